#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "drivers/ur/rtde/messages.hpp"
#include "drivers/ur/rtde/packet.hpp"
#include "drivers/ur/tcp_socket.hpp"

namespace mrroc::ur {

/// Where and how a controller is asked for its packages.
struct RtdeOptions {
  std::string address;   ///< host name or IP address of the controller
  int port = 30004;      ///< of its RTDE interface
  double frequency = 0;  ///< Hz, of its packages; 0: the greatest
  double timeout = 2;    ///< s, to connect, and for each answer
  double shortest = 0;   ///< s, between two packages where no frequency is given
};

/// One connection to the RTDE interface of a controller: it agrees on the fields, cuts the received bytes into data
/// packages, and keeps what could not be sent at once. A controller serves several connections, each with fields and a
/// frequency of its own. One thread.
///
/// `open`, `set_up_inputs` and `start` wait for answers and throw ConnectionError that names address, port and problem:
/// no connection, no answer, another protocol, refused fields. The other methods wait for nothing; a connection that
/// they find lost, or whose bytes are not RTDE, they close: `reason`.
class RtdeConnection {
 public:
  /// Fields that the client writes, and their next values.
  struct Input {
    rtde::Recipe recipe;
    std::vector<rtde::Value> values;
  };

  explicit RtdeConnection(RtdeOptions options);

  /// Connects and agrees on the fields that the controller sends.
  void open(const std::vector<std::string>& outputs);
  Input set_up_inputs(const std::vector<std::string>& fields);
  /// On return data packages arrive.
  void start();

  /// The values of the next data package, in the order of `outputs`; null: no more has come. Valid until the next call.
  const std::vector<rtde::Value>* next() noexcept;
  /// Appends the values to the bytes that are to be sent, which have space for one package of each input.
  void put(const Input& input) noexcept;
  /// Sends as many of these bytes as the socket takes.
  void flush() noexcept;
  bool has_unsent() const noexcept { return queued_begin_ != queued_end_; }
  /// Asks the controller to send no more.
  void pause() noexcept;

  void close(const std::string& reason) noexcept;
  bool is_open() const noexcept { return socket_.is_open(); }
  /// Why it was closed.
  const std::string& reason() const noexcept { return reason_; }
  /// "the RTDE interface at ADDRESS:PORT".
  const std::string& name() const noexcept { return socket_.name(); }
  int fd() const noexcept { return socket_.fd(); }
  /// Waits for bytes; false: `deadline` (CLOCK_MONOTONIC, ns) came first.
  bool wait_readable(std::int64_t deadline) const noexcept { return socket_.wait_readable(deadline); }

  // after `open`
  double frequency() const noexcept { return frequency_; }  ///< Hz, of the data packages
  /// Hz, of the controller's own periods.
  double own_frequency() const noexcept { return rtde::is_e_series(version_) ? kFrequency : kFrequencyOfCb3; }
  const rtde::ControllerVersion& version() const noexcept { return version_; }

 private:
  static constexpr double kFrequency = 500, kFrequencyOfCb3 = 125;

  template <class Action>
  auto agree(Action action);
  rtde::Packet ask(rtde::PacketType type, const std::vector<std::uint8_t>& payload);
  bool is_accepted(rtde::PacketType type, const std::vector<std::uint8_t>& payload);
  void keep_text(const rtde::Packet& packet) noexcept;
  std::string end_of_connection() const;

  RtdeOptions options_;
  TcpSocket socket_;
  std::string reason_;
  std::string text_;  ///< the controller's last text of this connection
  double frequency_ = 0;
  rtde::ControllerVersion version_;
  rtde::PacketBuffer buffer_;
  rtde::Recipe recipe_;  ///< of the data packages
  std::vector<rtde::Value> values_;
  std::vector<std::uint8_t> queue_;  ///< bytes that the socket has not taken yet
  std::size_t queued_begin_ = 0, queued_end_ = 0;
};

}  // namespace mrroc::ur
