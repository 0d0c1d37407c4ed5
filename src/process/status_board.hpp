#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "clock/clock.hpp"
#include "core/lockfree/shared_slot.hpp"
#include "links/telemetry/status_publisher.hpp"

namespace mrroc::process {

/// The status of a process for the operator, ten times a second of wall time: its heartbeat, its activity, its
/// counters. A separate thread publishes it, so that the task's thread only stores values. The process's behaviour does
/// not depend on it, so it may read the wall clock.
class StatusBoard {
 public:
  /// `publisher` must outlive the board.
  StatusBoard(links::StatusPublisher& publisher, const links::ProcessStatus& first, const clock::Clock& clock);
  ~StatusBoard();
  StatusBoard(const StatusBoard&) = delete;
  StatusBoard& operator=(const StatusBoard&) = delete;

  /// Task's thread: a step of an instruction. Does not allocate, lock or publish.
  void step(std::uint64_t instruction, std::string_view activity, std::uint64_t step) noexcept;
  /// The participant's thread: new counters. Does not allocate, lock or publish.
  void counters(const links::Counters& counters) noexcept;
  /// The participant's thread: what keeps its robot from moving; code `none` when nothing does. Does not allocate, lock
  /// or publish.
  void fault(const ErrorReport& fault) noexcept;
  /// From now on `publish` is also called every 20 ms of wall time, by the board's thread; an empty one ends this. When
  /// this function returns, no call of an earlier one is under way.
  void also(std::function<void()> publish);
  /// A new state of the process, published at once.
  void state(links::ProcessState state);
  /// The error that ends the process; published at once.
  void failed(const ErrorReport& error);

 private:
  struct Activity {
    std::uint64_t instruction = 0;
    std::uint64_t step = 0;
    char text[64]{};
  };
  void publish() noexcept;
  void run();

  links::StatusPublisher& publisher_;
  const clock::Clock& clock_;
  core::SharedSlot<Activity> activity_;
  core::SharedSlot<links::Counters> counters_;
  core::SharedSlot<ErrorReport> fault_;
  std::mutex mutex_;  // of status_ and the thread's end; never taken by a real-time thread
  std::condition_variable wake_;
  links::ProcessStatus status_;
  std::function<void()> also_;
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace mrroc::process
