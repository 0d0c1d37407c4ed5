mrroc_bench(faults SOURCES faults/campaign.cpp faults/detection.cpp faults/faults.cpp faults/row.cpp LINKS mrroc_testing)
target_include_directories(bench_faults PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
# the task that recovers, and its deployments
mrroc_bench(recovering SOURCES faults/recovering.cpp LINKS mrroc_ecp_shell mrroc_robot_irb6)
add_dependencies(bench_faults bench_recovering)
foreach(name recovering recovering_can)
  configure_file(faults/${name}.toml.in ${CMAKE_BINARY_DIR}/bench/${name}.toml @ONLY)
endforeach()
