mrroc_bench(move_step SOURCES move_step.cpp LINKS mrroc_language mrroc_process)
