#include "system/mrroc_run.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

namespace mrroc::test {

namespace {

constexpr std::chrono::seconds kPatienceWithOrphans{10};
constexpr std::chrono::milliseconds kPause{5};

/// The whole file; empty when it cannot be read, for example because its process ends meanwhile.
std::string read_file(const std::filesystem::path& path) try {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
} catch (const std::ios_base::failure&) {
  return "";
}

/// In a child: ends it with the test, even with a killed one; an endless deployment would starve the machine.
void end_with_test() {
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() == 1) _exit(125);
}

/// In a child: selects one of its permitted CPUs by number, from 1 on.
void keep_to_cpu(int number) {
  cpu_set_t allowed, one;
  CPU_ZERO(&one);
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
  number = 1 + (number - 1) % CPU_COUNT(&allowed);
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (!CPU_ISSET(cpu, &allowed) || --number > 0) continue;
    CPU_SET(cpu, &one);
    sched_setaffinity(0, sizeof one, &one);
    return;
  }
}

std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> pids;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const pid_t pid = std::stoi(name);
    if (parent_of(pid) == parent) pids.push_back(pid);
  }
  return pids;
}

/// The process that was started with `--name NAME`; -1 when there is none.
pid_t named(const std::string& name, const std::vector<pid_t>& pids) {
  const std::string wanted = std::string{"--name"} + '\0' + name + '\0';
  for (const pid_t pid : pids) {
    const std::string line = read_file("/proc/" + std::to_string(pid) + "/cmdline");
    if (line.find(wanted) != std::string::npos) return pid;
  }
  return -1;
}

/// Waits for the end of a run and checks it: see run_mrroc().
std::string finish(MrrocRun& run, const std::vector<std::string>& arguments, int expected, int patience) {
  const int code = run.wait(patience);
  std::string line = "mrroc";
  for (const std::string& argument : arguments) line += " " + argument;
  EXPECT_EQ(code, expected) << line << "\n" << run.out() << run.err();
  const auto is_option = [](const std::string& word) { return word == "--record" || word == "--trace"; };
  const auto option = std::find_if(arguments.begin(), arguments.end(), is_option);
  // a recording is empty when the run was refused
  if (option != arguments.end() && std::filesystem::is_regular_file(option[1]) && !std::filesystem::is_empty(option[1]))
    expect_laws(option[1]);
  return run.out() + run.err();
}

}  // namespace

pid_t parent_of(pid_t pid) {
  const std::string stat = read_file("/proc/" + std::to_string(pid) + "/stat");
  const std::size_t end = stat.rfind(')');
  if (end == std::string::npos) return -1;
  std::istringstream rest(stat.substr(end + 2));
  char state = 0;
  pid_t parent = -1;
  rest >> state >> parent;
  return state == 'Z' ? -1 : parent;
}

MrrocRun::MrrocRun(const std::vector<std::string>& arguments, int place, const std::filesystem::path& output) {
  const std::string program = std::string{MRROC_BINARY_DIR} + "/bin/mrroc";
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const bool says_where = std::find(words.begin(), words.end(), "--black-box") != words.end();
  if (!says_where && std::find(words.begin(), words.end(), "run") != words.end())
    words.insert(words.end(), {"--black-box", folder_.path() / "black-box"});  // not into the source folder
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const std::string out = output.empty() ? folder_.path() / "out" : output;
  const std::string err = output.empty() ? folder_.path() / "err" : output;
  pid_ = fork();
  if (pid_ == 0) {
    end_with_test();
    if (place > 0) keep_to_cpu(place);
    dup2(open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
    if (chdir(MRROC_SOURCE_DIR) != 0) _exit(126);
    execv(program.c_str(), argv.data());
    _exit(127);
  }
}

MrrocRun::~MrrocRun() {
  if (!has_ended()) {
    kill(pid_, SIGKILL);
    waitpid(pid_, &status_, 0);
  }
}

bool MrrocRun::has_ended() {
  if (!ended_ && waitpid(pid_, &status_, WNOHANG) == pid_) ended_ = true;
  return ended_;
}

int MrrocRun::wait(int patience) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(patience);
  while (!has_ended()) {
    if (std::chrono::steady_clock::now() > deadline) {
      ADD_FAILURE() << "mrroc does not end\n" << out() << err();
      kill(pid_, SIGKILL);
      waitpid(pid_, &status_, 0);
      ended_ = true;
    }
    std::this_thread::sleep_for(kPause);
  }
  return WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_);
}

bool MrrocRun::wait_for_output(const std::string& text) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(kPatience);
  for (;;) {
    const bool ended = has_ended();
    if (out().find(text) != std::string::npos) return true;
    if (ended || std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(kPause);
  }
}

void MrrocRun::signal(int number) const { kill(pid_, number); }

std::vector<pid_t> MrrocRun::children() const { return children_of(pid_); }

std::vector<pid_t> MrrocRun::descendants() const {
  std::vector<pid_t> pids = children();
  for (std::size_t i = 0; i < pids.size(); ++i) {
    const std::vector<pid_t> more = children_of(pids[i]);
    pids.insert(pids.end(), more.begin(), more.end());
  }
  return pids;
}

pid_t MrrocRun::child(const std::string& name) const { return named(name, children()); }

pid_t MrrocRun::descendant(const std::string& name) const { return named(name, descendants()); }

std::string MrrocRun::out() const { return read_file(folder_.path() / "out"); }

std::string MrrocRun::err() const { return read_file(folder_.path() / "err"); }

bool all_end(const std::vector<pid_t>& pids) {
  const auto deadline = std::chrono::steady_clock::now() + kPatienceWithOrphans;
  const auto lives = [](pid_t pid) { return parent_of(pid) >= 0; };
  while (std::any_of(pids.begin(), pids.end(), lives)) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(kPause);
  }
  return true;
}

std::string faulty_deployment(const std::string& kind, const std::string& clock) {
  return "[deployment]\nname = \"" + kind + "\"\nclock = \"" + clock +
         "\"\nheartbeat_timeout = 1\n"
         "[robots.arm]\ntype = \"irb6\"\nhardware = \"loopback\"\n"
         "program = \"" MRROC_BINARY_DIR "/tests/faulty_ecp\"\n";
}

std::string run_mrroc(const std::vector<std::string>& arguments, int expected, int patience) {
  MrrocRun run(arguments);
  return finish(run, arguments, expected, patience);
}

std::array<std::string, 2> run_two(const std::array<std::vector<std::string>, 2>& arguments, int expected,
                                   int patience) {
  MrrocRun first(arguments[0], 1), second(arguments[1], 2);
  return {finish(first, arguments[0], expected, patience), finish(second, arguments[1], expected, patience)};
}

void expect_laws(const std::filesystem::path& trace) {
  MrrocRun run({"trace", "check", trace.string()});
  EXPECT_EQ(run.wait(), 0) << run.out() << run.err();
}

std::string trace_hash(const std::filesystem::path& trace) {
  MrrocRun run({"trace", "hash", trace.string()});
  EXPECT_EQ(run.wait(), 0) << run.err();
  return run.out();
}

Load::Load(int processes) {
  for (int i = 0; i < processes; ++i) {
    const pid_t pid = fork();
    if (pid == 0) {
      end_with_test();
      volatile unsigned counter = 0;
      for (;;) counter = counter + 1;
    }
    pids_.push_back(pid);
  }
}

Load::~Load() {
  for (const pid_t pid : pids_) {
    kill(pid, SIGKILL);
    waitpid(pid, nullptr, 0);
  }
}

}  // namespace mrroc::test
