#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "cli/processes/process_plan.hpp"
#include "cli/record/servo_topics.hpp"
#include "cli/record/step_topics.hpp"
#include "cli/run/run_result.hpp"
#include "clock/host.hpp"
#include "config/deployment.hpp"
#include "edp/servo/servo_tap.hpp"
#include "process/record/claimed_file.hpp"
#include "process/record/step_ring.hpp"
#include "recording/recording_writer.hpp"

namespace mrroc::cli::record {

/// Records a run (`mrroc run --record`): takes the steps of all processes with a task from shared memory, on request
/// the ticks of all servos, too, and the operator's commands and injected faults from the runner, and writes them in
/// the order of their ticks, then of their processes, in its own thread. No process waits for the file; under a
/// simulated clock time waits when a ring is full, so that nothing is lost and the file is the same in every run. When
/// the file cannot be written the run continues.
class Recorder {
 public:
  /// What is recorded, and the clock; all must outlive the recorder.
  struct Recorded {
    const config::Deployment& deployment;
    const std::vector<PlannedProcess>& plan;
    const std::string& text;                 ///< of the deployment
    const std::vector<std::string>& faults;  ///< to be injected, with their numbers in the clock
    const clock::ClockHost& clock;
    bool servo_ticks = false;      ///< each tick of each servo, not the steps only
    std::optional<double> last{};  ///< s: only these last seconds, when the run fails or the operator records
  };

  /// `file`: empty, and only this run's. Starts the thread. Throws SystemError(resources) without memory.
  Recorder(const process::ClaimedFile& file, const Recorded& recorded);
  /// Ends the thread; the file has no end.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// The descriptor that the process inherits; -1 when nothing of it is recorded.
  int fd_of(const std::string& process) const noexcept;
  /// A command of the operator or of [[events]] that takes effect at its tick, before that tick is visible. Any thread.
  void take(const config::Event& event);
  /// A step of a task on another host, and its end in order. Any thread.
  void take(const std::string& process, recording::RecordedStep step);
  void take_end(const std::string& process, const recording::StepCounts& counts);
  bool keeps_last() const noexcept { return writer_.keeps_last(); }
  /// Of a run whose last seconds are kept: writes them to a file that does not exist yet; a relative path is in the
  /// working folder. Returns "the last 60 s; recording: /PATH". Throws std::logic_error when there is nothing to be
  /// written, std::runtime_error when the file exists or cannot be written. Any thread.
  std::string save(const std::filesystem::path& path) const;
  /// Call it once, when all processes have ended: writes what remains, the outcome and the index. Where the last
  /// seconds are kept they are written when the run has failed; else no file remains. Returns why the recording is
  /// incomplete, "cannot write the recording r.mcap: No space left on device"; empty: it is complete.
  std::string close(const RunResult& result);
  /// "120 steps of arm, 3 ticks of arm_edp"; empty: nothing was dropped. After close().
  std::string dropped() const;

 private:
  /// A process from which steps or servo ticks come; one without memory is on another host.
  struct Source {
    std::string process;
    std::string robot = {};  ///< whose servo it has
    std::optional<process::StepRing> steps = {};
    std::optional<edp::ServoTap> servo = {};
    std::optional<recording::StepCounts> counts = {};  ///< of a process on another host that has ended in order
    std::uint64_t cut = 0;                             ///< steps that were too long
    std::uint64_t servo_ticks = 0;                     ///< that are recorded
    Tick last = 0;                                     ///< of the last step or servo tick

    std::uint64_t dropped() const noexcept {
      return steps ? steps->dropped() : servo ? servo->dropped() : counts ? counts->dropped : 0;
    }
  };
  struct Event {
    const char* kind = "";
    std::string text;
  };
  /// Waits to be written in its order.
  struct Waiting {
    Tick tick = 0;
    Source* source = nullptr;  ///< null: an event
    std::variant<Event, recording::RecordedStep, edp::ServoSample> content;
  };

  void run();
  /// Takes everything that has come, and writes what no later arrival can precede.
  void drain(bool at_end);
  void take_faults(Tick before);
  void write(const Waiting& waiting);
  void write_step(Source& source, const recording::RecordedStep& step);
  void write_event(Tick tick, const std::string& kind, const std::string& text, int exit_code);
  /// Unless the process was killed.
  void write_end(const Source& source);
  /// Returns an errno; 0: there is the file, or none.
  int close_last(const RunResult& result);

  const Recorded recorded_;
  const process::ClaimedFile& file_;
  recording::RecordingWriter writer_;
  StepTopics topics_;
  std::optional<ServoTopics> servo_topics_;
  std::map<std::string, Source> sources_;  // by process
  Tick newest_ = 0;                        // of everything written
  std::vector<bool> fault_taken_;
  std::vector<Waiting> waiting_;
  std::mutex mutex_;             // of the two below
  std::vector<Waiting> events_;  // and steps of other hosts
  bool ending_ = false;
  std::condition_variable wake_;
  std::thread thread_;
};

}  // namespace mrroc::cli::record
