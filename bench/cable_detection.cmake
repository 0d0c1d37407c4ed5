if(TARGET mrroc_system_test) # uses the cable and the command runner of the tests
  mrroc_bench(cable_detection SOURCES cable_detection.cpp ${PROJECT_SOURCE_DIR}/tests/system/hosts/cable.cpp LINKS mrroc_system_test)
endif()
