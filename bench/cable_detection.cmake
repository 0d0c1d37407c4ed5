if(TARGET mrroc_system_test) # its cable and its run of the command are those of the tests
  mrroc_bench(cable_detection SOURCES cable_detection.cpp ${PROJECT_SOURCE_DIR}/tests/system/hosts/cable.cpp LINKS mrroc_system_test)
endif()
