mrroc_bench(faults SOURCES faults.cpp LINKS mrroc_testing)
