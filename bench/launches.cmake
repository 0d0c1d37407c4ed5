mrroc_bench(launches SOURCES launches.cpp LINKS mrroc_testing)
