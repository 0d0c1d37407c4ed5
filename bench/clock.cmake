mrroc_bench(clock_tick SOURCES clock_tick.cpp LINKS mrroc_clock)
