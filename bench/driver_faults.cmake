# troubles of drivers' devices and of the network to them
mrroc_bench(driver_faults SOURCES driver_faults/bus_device.cpp driver_faults/cell.cpp driver_faults/main.cpp
  driver_faults/troubles.cpp driver_faults/ur_device.cpp
  LINKS mrroc_can_hardware mrroc_loopback_hardware mrroc_netft_source mrroc_simulated_drives mrroc_testing mrroc_simulated_netft mrroc_simulated_ur mrroc_ur_hardware)
target_include_directories(bench_driver_faults PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_definitions(bench_driver_faults PRIVATE MRROC_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
