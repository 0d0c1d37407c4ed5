#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "clock/gate.hpp"
#include "clock/wall/package_clock.hpp"
#include "core/lockfree/latest_value.hpp"
#include "core/lockfree/shared_slot.hpp"
#include "drivers/ur/rtde_connection.hpp"
#include "drivers/ur/wrench/flange_wrench.hpp"

namespace mrroc::ur {

/// The controller and the times of its client, s.
struct WrenchOptions {
  std::string address;
  int port = 30004;
  double frequency = 0;      ///< Hz, of the packages; 0: the controller's greatest
  double timeout = 0.05;     ///< without a package, after which the connection is made again
  double start_timeout = 5;  ///< to connect, and for the first package
  bool lockstep = false;     ///< the controller is a stand-in that takes part in lockstep: `timeout` has no effect
};

/// A wrench of the controller, and when it arrived.
struct MeasuredWrench {
  WrenchPackage package;
  TorquePoint point = TorquePoint::flange;
  std::int64_t arrival_ns = 0;  ///< CLOCK_MONOTONIC
};

struct WrenchCounters {
  std::uint64_t packages = 0;
  std::uint64_t lost = 0;         ///< missing in the controller's time
  std::uint64_t late = 0;         ///< received more than a period after their time
  std::uint64_t doubled = 0;      ///< with the time of the one before
  std::uint64_t restarts = 0;     ///< of the controller's time
  std::uint64_t connections = 0;  ///< made, the first included
};

/// "of 7000 packages 3 lost, 1 late", with every counter of a disturbance that is not 0; empty: there was none.
std::string disturbances(const WrenchCounters& counters);

/// Receives a controller's wrench by RTDE in a thread of its own, which begins and ends with this object; the newest
/// one is handed over without locks. The connection has outputs only, so it takes no register from any other client. It
/// is made again when it is lost, or when no package has come for the timeout.
///
/// In lockstep the reader waits for the package of its tick (`await`), and a lost connection stays lost.
class WrenchClient {
 public:
  /// Connects and waits for the first package; in lockstep it comes in tick 0. Throws ConnectionError as
  /// RtdeConnection, and when none has come in `start_timeout`; std::system_error when there is no thread.
  explicit WrenchClient(const WrenchOptions& options);
  ~WrenchClient();
  WrenchClient(const WrenchClient&) = delete;
  WrenchClient& operator=(const WrenchClient&) = delete;

  /// The newest wrench; unchanged until the next call. One thread; no lock, no allocation.
  const MeasuredWrench& newest() noexcept { return *handed_.load(); }
  /// Lockstep: the wrench of tick `tick`, or of the newest tick before it that has a package, as soon as it has come.
  /// Null: the connection is lost, or no package has come within kLockstepTimeout. `period` of the servo, s. The thread
  /// of `newest`.
  const MeasuredWrench* await(Tick tick, double period) noexcept;
  /// Any thread.
  WrenchCounters counters() const noexcept;

 private:
  void connect();
  void await_first();
  void serve() noexcept;
  void serve_lockstep() noexcept;
  void receive() noexcept;
  void take(const WrenchPackage& package) noexcept;
  bool is_ending(int wait_ms) const noexcept;

  const WrenchOptions options_;
  int end_ = -1;  ///< eventfd that ends the thread
  // the thread's own
  RtdeConnection connection_;
  clock::PackageClock clock_;
  MeasuredWrench newest_;
  WrenchCounters counted_;
  // handed over
  core::LatestValue<MeasuredWrench> handed_;
  std::atomic<bool> lost_{false};  ///< in lockstep
  clock::Gate received_;           ///< of lockstep: a package has come, or none will
  core::SharedSlot<WrenchCounters> counters_;
  std::thread thread_;
};

}  // namespace mrroc::ur
