#pragma once

#include <arpa/inet.h>
#include <poll.h>
#include <unistd.h>

#include "edp/driver.hpp"
#include "packet.hpp"

namespace mrroc {

/// Streams set-points of positions. Silent when 10 ticks have passed without an answer.
class Stream final : public edp::Hardware {
 public:
  explicit Stream(const edp::DriverContext& context)
      : count_(context.model.joint_count()), socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK, 0)) {
    const auto& keys = context.robot.driver;
    address_.sin_family = AF_INET;
    address_.sin_port = htons(static_cast<std::uint16_t>(keys.number("port")));
    if (::inet_pton(AF_INET, keys.text("address").c_str(), &address_.sin_addr) != 1)
      throw SystemError(ErrorCode::configuration, "address '" + keys.text("address") + "', expected an IPv4 address");
    offset_ = shafts_ = target_ = JointVector::Zero(count_);
  }
  ~Stream() override { ::close(socket_); }

  void open() override {
    ::connect(socket_, reinterpret_cast<const sockaddr*>(&address_), sizeof address_);
    exchange();
    pollfd ready{socket_, POLLIN, 0};
    if (::poll(&ready, 1, 2000) != 1 || !receive())
      throw HardwareError(ErrorCode::hardware_silent, "no controller answers, expected one at the given port");
    target_ = shafts_;
  }
  void enable(bool on) noexcept override { enabled_ = on; }
  void read(Tick tick, edp::HardwareInput& input) noexcept override {
    if (receive()) last_ = tick;
    input.motors = shafts_ + offset_;
    input.current = JointVector::Zero(count_);
    input.synchronised = true;
    input.tick = last_;
    input.fault = tick - last_ > 10 ? ErrorCode::hardware_silent : ErrorCode::none;
  }
  void set_points(const JointVector& position, const JointVector&) noexcept override { target_ = position - offset_; }
  void write(Tick, const JointVector&) noexcept override { exchange(); }
  void set_origin(const JointVector& shift) noexcept override { offset_ += shift; }

 private:
  void exchange() noexcept {
    Packet packet{++number_, enabled_, {}};
    for (int i = 0; i < count_; ++i) packet.position[i] = target_[i];
    ::send(socket_, &packet, sizeof packet, 0);
  }
  /// True: at least one answer has come. Packets of another length, and doubled or overtaken ones, change nothing.
  bool receive() noexcept {
    const auto before = received_;
    Packet packet{};
    for (ssize_t size = 0; (size = ::recv(socket_, &packet, sizeof packet, MSG_TRUNC)) >= 0;) {
      if (size != sizeof packet || packet.number <= received_) continue;
      received_ = packet.number;
      for (int i = 0; i < count_; ++i) shafts_[i] = packet.position[i];
    }
    return received_ != before;
  }

  int count_, socket_;
  sockaddr_in address_{};
  JointVector shafts_, target_, offset_;
  bool enabled_ = false;
  unsigned long long number_ = 0, received_ = 0;
  Tick last_ = 0;
};

}  // namespace mrroc
