// Rules about the source that no run can check.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "text_of.hpp"

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = MRROC_SOURCE_DIR;
// headers of src/links that contain DDS; only src/links and its tests may include them
const std::set<std::string> kInternal = {"cdr_type.hpp", "node_impl.hpp", "codec.hpp",
                                         "entity.hpp",   "fields.hpp",    "wire_parts.hpp"};

using Words = std::vector<std::string>;

using mrroc::test::text_of;

bool has_one_of(const fs::path& file, const Words& words) {
  const std::string text = text_of(file);
  return std::any_of(words.begin(), words.end(),
                     [&text](const std::string& word) { return text.find(word) != std::string::npos; });
}

/// Every C++ file of the project's layers.
std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const char* layer :
       {"include", "src", "robots", "sensors", "sim", "edp", "drivers", "vsp", "ecp", "mp", "tasks", "cli"}) {
    if (!fs::exists(kRoot / layer)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / layer)) {
      if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp") files.push_back(entry.path());
    }
  }
  return files;
}

bool in_links(const fs::path& file) { return file.string().starts_with((kRoot / "src/links/").string()); }

TEST(Structure, DdsIsIncludedOnlyInLinksAndNotInPublicHeaders) {
  const Words shows_dds = {"#include <dds/",
                           "#include \"dds/",
                           "#include \"messages.h\"",
                           "#include \"links/wire/codec.hpp\"",
                           "#include \"links/transport/entity.hpp\"",
                           "#include \"links/wire/fields.hpp\"",
                           "#include \"links/wire/wire_parts.hpp\""};
  int users = 0;
  for (const fs::path& file : sources()) {
    if (!has_one_of(file, shows_dds)) continue;
    ++users;
    EXPECT_TRUE(in_links(file)) << file;
    EXPECT_TRUE(file.extension() == ".cpp" || kInternal.contains(file.filename())) << file;
  }
  EXPECT_GT(users, 5) << "the search finds nothing";
}

TEST(Structure, NoCallWaitsOrTimesByTheWallClockOfDds) {
  const Words forbidden = {"dds_waitset", "dds_qset_latency_budget", "dds_set_listener", "dds_time(", "dds_sleepfor"};
  for (const fs::path& file : sources()) {
    EXPECT_FALSE(has_one_of(file, forbidden)) << file;
  }
}

/// Names of the functions called by the function that starts with `head`; it ends at the first brace at the start of a
/// line.
std::set<std::string> calls_in(const fs::path& file, const std::string& head) {
  const std::string text = text_of(file);
  const std::size_t begin = text.find(head);
  if (begin == std::string::npos) return {};
  const std::string body = text.substr(begin + head.size(), text.find("\n}", begin) - begin - head.size());
  const std::regex call("(\\w+)(<[^<>()]*>)?\\(");
  std::set<std::string> names;
  for (std::sregex_iterator match(body.begin(), body.end(), call), end; match != end; ++match)
    names.insert((*match)[1]);
  return names;
}

// original's defect 16: streams and allocation in signal handlers; C++ code between vfork and exec
TEST(Structure, SignalHandlersAndForkedChildrenCallOnlyWhatIsSafeThere) {
  const fs::path handler = kRoot / "src/process/signals/end_request.cpp", child = kRoot / "cli/processes/child.cpp";
  const fs::path crash = kRoot / "edp/drivers/driver_calls.cpp";
  for (const fs::path& file : sources()) {
    EXPECT_FALSE(has_one_of(file, {"vfork", "popen(", "std::system(", "posix_spawn"})) << file;
    EXPECT_TRUE(file == handler || file == crash || !has_one_of(file, {"sigaction(", "std::signal("})) << file;
    EXPECT_TRUE(file == child || !has_one_of(file, {" fork()", "::fork()"})) << file;
  }
  // a store into a lock-free atomic, and Clock::interrupt: another one and a futex call
  const std::set<std::string> in_handler = {"if", "static_cast", "_exit", "alarm", "load", "interrupt", "getppid"};
  const std::set<std::string> in_child = {"if",          "prctl",  "getppid", "_exit", "sigemptyset",
                                          "sigprocmask", "signal", "setpgid", "dup2",  "open",
                                          "fcntl",       "execv",  "c_str",   "write"};
  const std::set<std::string> in_crash = {"if",     "char", "static_cast", "write_text", "write",
                                          "strlen", "data", "signal",      "raise"};
  for (const auto& [file, head, allowed] :
       {std::tuple(handler, "void on_request(int) {", in_handler),
        std::tuple(handler, "void on_alarm(int) {", in_handler), std::tuple(child, "void execute(", in_child),
        std::tuple(crash, "void on_crash(int number) {", in_crash)}) {
    const std::set<std::string> calls = calls_in(file, head);
    EXPECT_GT(calls.size(), 3u) << head << " was not found";
    for (const std::string& call : calls) EXPECT_TRUE(allowed.contains(call)) << head << " calls " << call;
  }
}

}  // namespace
