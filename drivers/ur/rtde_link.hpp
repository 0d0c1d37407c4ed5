#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/lockfree/latest_value.hpp"
#include "drivers/ur/command.hpp"
#include "drivers/ur/options.hpp"
#include "drivers/ur/robot_state.hpp"
#include "drivers/ur/rtde/messages.hpp"
#include "drivers/ur/rtde/packet.hpp"
#include "drivers/ur/tcp_socket.hpp"
#include "edp/package_clock.hpp"
#include "edp/robot_clock.hpp"
#include "edp/safety/fault.hpp"

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
class RtdeLink {
 public:
  /// Copies the options; they must be valid. Without a frequency among them packages come once in `servo_period` (s) at
  /// most.
  RtdeLink(const UrOptions& options, double servo_period);
  ~RtdeLink();
  RtdeLink(const RtdeLink&) = delete;
  RtdeLink& operator=(const RtdeLink&) = delete;

  /// Connects, and returns when the first package has come. Main thread. Throws ConnectionError that names address,
  /// port and problem: no connection, no answer, protocol version, refused fields.
  void open();

  /// Waits until packages have come since the last call; false: none before `deadline` (CLOCK_MONOTONIC, ns). Servo
  /// thread.
  bool wait(std::int64_t deadline) noexcept;
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

 private:
  struct Output {
    rtde::Recipe recipe;
    std::vector<rtde::Value> values;
  };

  void connect();
  void connect_in_time();
  rtde::Packet ask(rtde::PacketType type, const std::vector<std::uint8_t>& payload, std::int64_t deadline);
  Output set_up_inputs(const std::vector<std::string>& fields, std::int64_t deadline);
  void keep_text(const rtde::Packet& packet) noexcept;
  std::string end_of_connection() const;
  void disconnect(const std::string& reason) noexcept;
  void run() noexcept;
  void poll() noexcept;
  double frequency_of(std::uint32_t major) const noexcept;
  void reconnect() noexcept;
  void receive() noexcept;
  void take(const rtde::Packet& packet) noexcept;
  void transmit() noexcept;
  void put(const Output& output) noexcept;
  void report(const std::string& reason) noexcept;
  void flush() noexcept;
  bool queue_empty() const noexcept { return queued_begin_ == queued_end_; }

  const UrOptions options_;
  const double servo_period_;
  std::atomic<double> frequency_{0};
  TcpSocket socket_;
  std::string reason_;  ///< of the last disconnection
  std::string text_;    ///< the controller's last text of this connection
  rtde::PacketBuffer buffer_;
  rtde::Recipe state_recipe_;
  std::vector<rtde::Value> state_values_;
  Output set_points_, terminals_, slider_;
  std::vector<std::uint8_t> queue_;  ///< bytes that the socket has not taken yet
  std::size_t queued_begin_ = 0, queued_end_ = 0;
  edp::PackageClock clock_;
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
