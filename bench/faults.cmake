mrroc_bench(faults SOURCES faults/campaign.cpp faults/detection.cpp faults/faults.cpp faults/row.cpp LINKS mrroc_testing)
target_include_directories(bench_faults PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
# the task that recovers, and its deployment
mrroc_bench(recovering SOURCES faults/recovering.cpp LINKS mrroc_ecp_shell mrroc_robot_irb6)
add_dependencies(bench_faults bench_recovering)
configure_file(faults/recovering.toml.in ${CMAKE_BINARY_DIR}/bench/recovering.toml @ONLY)
