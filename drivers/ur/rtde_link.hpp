#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "clock/wall/package_clock.hpp"
#include "core/lockfree/latest_value.hpp"
#include "drivers/ur/command.hpp"
#include "drivers/ur/options.hpp"
#include "drivers/ur/robot_state.hpp"
#include "drivers/ur/rtde_connection.hpp"
#include "edp/robot_clock.hpp"
#include "edp/safety/fault.hpp"
#include "mrroc/types.hpp"

namespace mrroc::ur {

/// Packages since `open`.
struct LinkCounters : edp::BeatCounters {
  std::uint64_t sent = 0;         ///< set-points
  std::uint64_t unsent = 0;       ///< set-points that newer ones have replaced before they could be sent
  std::uint64_t connections = 0;  ///< made, the first included
};

/// The RTDE connection to one controller. Its thread is the only one that uses the socket: it connects, agrees on the
/// recipes, receives the robot's states and sends set-points. It connects again when the connection is lost, when the
/// stream is not RTDE, or when no package has come for the timeout. Both directions are handed over lock-free: the
/// servo thread never waits for it. The thread has the scheduling class of the thread that calls `open`.
///
/// In lockstep the servo waits for the package of each tick (`await`), there is no timeout of packages, and a lost
/// connection stays lost.
class RtdeLink {
 public:
  /// Copies the options; they must be valid. Without a frequency among them packages come once in `servo_period` (s) at
  /// most.
  RtdeLink(const UrOptions& options, double servo_period);
  ~RtdeLink();
  RtdeLink(const RtdeLink&) = delete;
  RtdeLink& operator=(const RtdeLink&) = delete;

  /// Connects, and returns when the first package has come; in lockstep it comes in tick 0. Main thread. Throws
  /// ConnectionError that names address, port and problem: no connection, no answer, protocol version, refused fields.
  void open();

  /// Waits until packages have come since the last call; false: none before `deadline` (CLOCK_MONOTONIC, ns). Servo
  /// thread.
  bool wait(std::int64_t deadline) noexcept;
  /// Lockstep: the state of tick `tick`, or of the newest tick before it that has a package, as soon as it has come.
  /// Null: the connection is lost, or nothing has come within kLockstepTimeout. Servo thread.
  const RobotState* await(Tick tick) noexcept;
  /// The newest state; null before the first. Servo thread.
  const RobotState* newest() noexcept { return for_servo_.load(); }
  /// The same for one other thread.
  const RobotState* newest_for_start() noexcept { return for_start_.load(); }
  /// Hands set-points over; they are sent at once. Servo thread. One system call, which does not block.
  void send(const Command& command) noexcept;

  /// Whether packages are expected now. Any thread.
  bool is_up() const noexcept { return up_.load(std::memory_order_acquire); }
  /// Why the connection was lost or cannot be made; null: it never was. Servo thread.
  const edp::DriverText* problem() noexcept { return problem_for_servo_.load(); }
  /// The same for one other thread.
  const edp::DriverText* problem_for_start() noexcept { return problem_for_start_.load(); }
  LinkCounters counters() const noexcept;
  /// Hz, of the packages. After `open`. Any thread.
  double frequency() const noexcept { return frequency_.load(std::memory_order_relaxed); }
  /// Hz, of the periods in which the controller executes its program; in lockstep those of the servo. After `open`. Any
  /// thread.
  double program_frequency() const noexcept { return program_frequency_.load(std::memory_order_relaxed); }

 private:
  void connect();
  void connect_in_time();
  void lose(const std::string& reason) noexcept;
  void run() noexcept;
  void poll() noexcept;
  void reconnect() noexcept;
  void receive() noexcept;
  bool take(const std::vector<rtde::Value>& values) noexcept;
  void transmit() noexcept;
  void report(const std::string& reason) noexcept;

  const UrOptions options_;
  const double servo_period_;
  std::atomic<double> frequency_{0}, program_frequency_{0};
  RtdeConnection connection_;
  RtdeConnection::Input set_points_, terminals_, slider_;
  clock::PackageClock clock_;
  RobotState state_;
  std::int64_t last_received_ = 0;
  std::optional<ControllerIo> outputs_;  ///< as last sent
  std::int32_t last_sequence_ = 0;
  bool started_sending_ = false;

  core::LatestValue<RobotState> for_servo_, for_start_;
  core::LatestValue<Command> commands_;
  core::LatestValue<edp::DriverText> problem_for_servo_, problem_for_start_;
  std::atomic<bool> up_{false}, end_{false};
  std::atomic<std::uint64_t> packages_{0}, lost_{0}, late_{0}, doubled_{0}, bunched_{0}, sent_{0}, unsent_{0},
      connections_{0};
  int wake_ = -1;      ///< eventfd of this thread: the servo has something to send
  int received_ = -1;  ///< eventfd of the servo: packages have come
  std::thread thread_;
};

}  // namespace mrroc::ur
