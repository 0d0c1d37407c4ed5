# Every folder of robots/ takes part automatically, as in the kinematics program.
mrroc_kinematics_loader(reachable_robots)
mrroc_bench(reachable SOURCES reachable.cpp ${reachable_robots_SOURCE} LINKS ${reachable_robots_LIBRARIES})
