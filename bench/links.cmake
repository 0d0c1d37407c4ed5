if(TARGET mrroc_edp)
  mrroc_bench(link_roundtrip
    SOURCES link_roundtrip.cpp
    LINKS mrroc_bare_ping_pong mrroc_edp mrroc_loopback_hardware mrroc_robot_irb6)
endif()
mrroc_bench(latest_value SOURCES latest_value.cpp LINKS mrroc_language mrroc_links)
