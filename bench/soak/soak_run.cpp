#include "soak/soak_run.hpp"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "cli/trace/hash.hpp"
#include "cooperative_transfer/report/variant.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::soak {

namespace {

constexpr double kServoPeriod = 0.002;  // s, the deployment's
constexpr double kTold = 600;           // s of simulated time between two lines about the progress

/// The task's deployment with the soak's MP, and the trigger that ends its laps.
std::filesystem::path write_deployment(const std::filesystem::path& folder, double seconds) {
  const std::filesystem::path file = transfer::write_variant({}, folder);
  std::ifstream stream(file);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  stream.close();
  const std::string stock = "\"cooperative_transfer_mp\"";
  const std::size_t place = text.find(stock);
  if (place == std::string::npos) throw std::runtime_error("the task's deployment has no program " + stock);
  text.replace(place, stock.size(), "\"" MRROC_BINARY_DIR "/bench/soak_mp\"");
  text += "\n[[events]]\ntick = " + std::to_string(std::llround(seconds / kServoPeriod)) + "\ncommand = \"trigger\"\n";
  if (!(std::ofstream(file) << text).flush()) throw std::runtime_error("cannot write " + file.string());
  return file;
}

/// `mrroc run` and its output.
class Run {
 public:
  Run(const std::filesystem::path& deployment, const std::filesystem::path& trace) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
    const std::string mrroc = MRROC_BINARY_DIR "/bin/mrroc";
    pid_ = fork();
    if (pid_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      dup2(ends[1], STDOUT_FILENO);
      dup2(ends[1], STDERR_FILENO);
      close(ends[0]);
      close(ends[1]);
      execl(mrroc.c_str(), mrroc.c_str(), "run", deployment.c_str(), "--clock", "lockstep", "--record", trace.c_str(),
            "--black-box", "", static_cast<char*>(nullptr));
      _exit(127);
    }
    close(ends[1]);
    output_.reset(fdopen(ends[0], "r"));
    if (pid_ < 0 || !output_) throw std::runtime_error("cannot start " + mrroc);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  pid_t pid() const noexcept { return pid_; }
  /// False at the end.
  bool read_line(std::string& line) {
    line.clear();
    for (int c = 0; (c = std::fgetc(output_.get())) != EOF && c != '\n';) line += static_cast<char>(c);
    return std::feof(output_.get()) == 0 || !line.empty();
  }
  void wait(SoakRun& run) {
    int status = 0;
    rusage usage{};
    wait4(pid_, &status, 0, &usage);
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    run.peak = usage.ru_maxrss;  // of the runner and of all for which it has waited
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };
  pid_t pid_ = -1;
  std::unique_ptr<std::FILE, Close> output_;
};

/// Stores the values of a line of the runner's report; ignores other lines.
void read_report(const std::string& line, SoakRun& run) {
  unsigned long long ticks = 0, missed = 0, late = 0;
  if (std::sscanf(line.c_str(), " %*s %llu ticks, %llu missed, %llu late", &ticks, &missed, &late) == 3) {
    ++run.servos;
    run.ticks += ticks;
    run.missed += missed;
    run.late += late;
  } else if (std::sscanf(line.c_str(), " mp %llu steps of several robots, skew %llu", &ticks, &missed) == 2) {
    run.steps = ticks;
    run.skew = missed;
  } else if (line.find(" of wall time") != std::string::npos) {
    run.summary = line;
  }
}

}  // namespace

SoakRun soak(double seconds) {
  const task_test::ScratchFolder folder;
  const std::filesystem::path trace = folder.path() / "run.mcap";
  Run process(write_deployment(folder.path(), seconds), trace);
  SoakRun run;
  double next = kTold;
  for (std::string line; process.read_line(line);) {
    Sample sample;
    if (std::sscanf(line.c_str(), "mp | lap %*d %lf", &sample.time) == 1) {
      sample.resident = resident(process.pid());
      run.samples.push_back(sample);
      if (sample.time < next) continue;
      std::printf("%s\n", line.c_str());
      std::fflush(stdout);
      next += kTold;
    } else if (line.starts_with("mrroc: ") || line.find(" | ") != std::string::npos) {
      run.output += line + "\n";
    } else {
      read_report(line, run);
    }
  }
  process.wait(run);
  if (run.exit_code != 0) return run;
  run.trace_bytes = std::filesystem::file_size(trace);
  run.hash = cli::trace::hash_of(trace).text;
  return run;
}

}  // namespace mrroc::soak
