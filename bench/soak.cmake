mrroc_bench(soak SOURCES soak/resident.cpp soak/soak.cpp soak/soak_run.cpp LINKS mrroc_runner mrroc_testing mrroc_transfer_report)
target_include_directories(bench_soak PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
# the MP of its deployment
mrroc_bench(soak_mp SOURCES soak/soak_mp.cpp LINKS mrroc_mp_shell mrroc_robot_irb6 mrroc_robot_two_finger_gripper
  mrroc_sensor_force_torque mrroc_sensor_tracker)
target_include_directories(bench_soak_mp PRIVATE ${PROJECT_SOURCE_DIR}/tasks)
add_dependencies(bench_soak bench_soak_mp)
