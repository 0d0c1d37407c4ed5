#include "mrroc/testing/run.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "messages/message_table.hpp"
#include "messages/mrroc_msgs/step.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "recording/recording_reader.hpp"

namespace mrroc::task_test {

namespace {

/// Every process of a run has this variable in its environment, so that remaining processes can be found.
constexpr const char* kMark = "MRROC_TEST_RUN";

/// The whole file; empty when it cannot be read, for example because its process ends meanwhile.
std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::array<char, 65536> part{};
  while (file.read(part.data(), part.size()) || file.gcount() > 0)
    text.append(part.data(), static_cast<std::size_t>(file.gcount()));
  return text;
}

pid_t start(const std::vector<std::string>& words, const std::filesystem::path& output, const std::string& mark) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  std::vector<char*> environment;
  for (char** each = environ; *each != nullptr; ++each) environment.push_back(*each);
  environment.push_back(const_cast<char*>(mark.c_str()));
  environment.push_back(nullptr);
  const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  const pid_t pid = fork();
  if (pid == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    execve(words.front().c_str(), argv.data(), environment.data());
    _exit(127);
  }
  close(file);
  if (pid < 0) throw std::runtime_error("cannot start " + words.front());
  return pid;
}

int wait_for(pid_t pid, int patience) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(patience);
  int status = 0;
  pid_t ended = 0;
  while ((ended = waitpid(pid, &status, WNOHANG)) == 0) {
    if (std::chrono::steady_clock::now() > deadline) kill(pid, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (ended < 0) throw std::runtime_error("mrroc has ended unseen: SIGCHLD must not be ignored");
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

bool is_zombie(const std::filesystem::path& process) {
  const std::string stat = text_of(process / "stat");
  const std::size_t end = stat.rfind(')');
  return end == std::string::npos || end + 2 >= stat.size() || stat[end + 2] == 'Z';
}

/// Processes with `mark` in their environment: "<pid> <command>".
std::vector<std::string> find_processes(const std::string& mark) {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    if (text_of(entry.path() / "environ").find(mark) == std::string::npos || is_zombie(entry.path())) continue;
    std::string command = text_of(entry.path() / "cmdline");
    std::replace(command.begin(), command.end(), '\0', ' ');
    found.push_back(command.insert(0, name + " "));
  }
  return found;
}

/// Processes that remain a second after the end of the run; they are killed.
std::vector<std::string> kill_leftovers(const std::string& mark) {
  std::vector<std::string> found = find_processes(mark);
  for (int i = 0; i < 20 && !found.empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    found = find_processes(mark);
  }
  for (const std::string& each : found) kill(static_cast<pid_t>(std::stoi(each)), SIGKILL);
  return found;
}

/// The words of StepEnding, behind `none`.
constexpr std::array kEndings{"",        "condition",       "generator",      "end_motion",
                              "stopped", "non_fatal_error", "hardware_error", "system_error"};

std::string json_of(std::span<const std::byte> step) {
  for (const messages::MessageType& type : messages::message_types())
    if (type.name == messages::mrroc_msgs::Step::kType) return type.json(step);
  return "";
}

std::vector<Step> read_steps(const std::filesystem::path& file) {
  std::vector<Step> steps;
  recording::RecordingReader reader(file);
  while (const auto message = reader.next()) {
    if (message->type != messages::mrroc_msgs::Step::kType) continue;
    const auto read = messages::from_cdr<messages::mrroc_msgs::Step>(message->cdr);
    Step step;
    step.tick = read.tick;
    step.process = read.process;
    step.instruction = read.name;
    step.is_move = read.is_move;
    step.step = read.step_number;
    step.ending = kEndings.at(read.ending);
    step.json = json_of(message->cdr);
    steps.push_back(std::move(step));
  }
  return steps;
}

/// The rest of every line that starts with `beginning`.
std::vector<std::string> rests_of(const std::string& text, const std::string& beginning) {
  std::vector<std::string> rests;
  for (std::size_t place = 0; place < text.size();) {
    const std::size_t end = std::min(text.find('\n', place), text.size());
    if (text.compare(place, beginning.size(), beginning) == 0)
      rests.push_back(text.substr(place + beginning.size(), end - place - beginning.size()));
    place = end + 1;
  }
  return rests;
}

}  // namespace

std::vector<Step> RunResult::steps_of(const std::string& process) const {
  std::vector<Step> own;
  std::copy_if(steps.begin(), steps.end(), std::back_inserter(own),
               [&](const Step& step) { return step.process == process; });
  return own;
}

std::vector<Step> RunResult::endings() const {
  std::vector<Step> ends;
  std::copy_if(steps.begin(), steps.end(), std::back_inserter(ends),
               [](const Step& step) { return !step.ending.empty(); });
  return ends;
}

DeploymentRun::DeploymentRun(std::filesystem::path command, std::filesystem::path deployment)
    : command_(std::move(command)), deployment_(std::move(deployment)) {}

DeploymentRun& DeploymentRun::inject(std::string fault) {
  faults_.push_back(std::move(fault));
  return *this;
}

DeploymentRun& DeploymentRun::option(std::string word) {
  options_.push_back(std::move(word));
  return *this;
}

RunResult DeploymentRun::run(int patience) {
  const ScratchFolder folder;
  const std::filesystem::path steps = folder.path() / "steps.mcap", motion = folder.path() / "motion",
                              output = folder.path() / "output";
  std::vector<std::string> words{command_, "run",      deployment_, "--quiet",     "--record",
                                 steps,    "--motion", motion,      "--black-box", ""};
  if (std::find(options_.begin(), options_.end(), "--clock") == options_.end())
    words.insert(words.end(), {"--clock", "lockstep"});
  for (const std::string& fault : faults_) words.insert(words.end(), {"--inject", fault});
  words.insert(words.end(), options_.begin(), options_.end());
  const std::string mark = std::string{kMark} + "=" + folder.path().string();
  RunResult result;
  result.exit_code = wait_for(start(words, output, mark), patience);
  result.leftovers = kill_leftovers(mark);
  result.output = text_of(output);
  if (const auto reasons = rests_of(result.output, "mrroc: "); !reasons.empty()) result.error = reasons.front();
  for (const std::string& rest : rests_of(result.output, "injected at tick "))
    result.injected[rest.substr(rest.find(": ") + 2)] = std::stoull(rest);
  if (recording::is_recording(steps)) result.steps = read_steps(steps);
  if (std::filesystem::exists(motion)) result.motion = read_motion(motion);
  return result;
}

}  // namespace mrroc::task_test
