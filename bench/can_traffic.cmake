# bits of the frames on a CAN bus: docs/how-to/can.md
mrroc_bench(can_traffic SOURCES can_traffic.cpp LINKS mrroc_can_hardware mrroc_loopback_hardware mrroc_simulated_drives mrroc_testing)
target_compile_definitions(bench_can_traffic PRIVATE MRROC_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_include_directories(bench_can_traffic PRIVATE ${PROJECT_SOURCE_DIR}/tests/drivers/socketcan)
