// Cyclone DDS is not instrumented: what the thread sanitizer says of its own data is not to be had.
extern "C" const char* __tsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions() { return "race:libddsc\nmutex:libddsc\ndeadlock:libddsc\n"; }
