// Cyclone DDS is not instrumented: what the thread sanitizer says of its own data is not to be had. Its wrappers of the
// system's calls are named one by one, so that races in listeners of ours, which it calls, still show.
extern "C" const char* __tsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions() {
  return "race_top:libddsc\n"
         "race:ddsrt_recvmsg\n"
         "race:ddsrt_sendmsg\n"
         "race:ddsrt_mutex_\n";
}
