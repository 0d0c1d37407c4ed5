#pragma once

#include <arpa/inet.h>
#include <poll.h>
#include <unistd.h>

#include "edp/driver.hpp"
#include "packet.hpp"

namespace mrroc {

/// Streams set-points of positions. A position is that of the tick whose set-point it answers. Silent after 50 ticks.
class Stream final : public edp::Hardware {
 public:
  explicit Stream(const edp::DriverContext& context)
      : count_(context.model.joint_count()), socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK, 0)) {
    const std::string address = context.robot.driver.text("address");
    const auto port = static_cast<std::uint16_t>(context.robot.driver.number("port"));
    address_ = {AF_INET, htons(port), {::inet_addr(address.c_str())}, {}};
    if (address_.sin_addr.s_addr == INADDR_NONE)
      throw SystemError(ErrorCode::configuration, "address '" + address + "', expected an IPv4 address");
    offset_ = shafts_ = target_ = JointVector::Zero(count_);
  }
  ~Stream() override { ::close(socket_); }

  void open() override {
    ::connect(socket_, reinterpret_cast<const sockaddr*>(&address_), sizeof address_);
    exchange(0);
    pollfd ready{socket_, POLLIN, 0};
    if (::poll(&ready, 1, 2000) != 1 || !receive())
      throw HardwareError(ErrorCode::hardware_silent, "no controller answers, expected one at the given port");
  }
  void enable(bool on) noexcept override { enabled_ = on; }
  void read(Tick tick, edp::HardwareInput& input) noexcept override {
    if (!receive() && answered_ == 0) answered_ = tick;
    input.motors = shafts_ + offset_;
    input.current = JointVector::Zero(count_);
    input.synchronised = true;
    input.time = static_cast<double>(answered_);
    input.fault = tick - answered_ > 50 ? ErrorCode::hardware_silent : ErrorCode::none;
  }
  void set_points(const JointVector& position, const JointVector&) noexcept override { target_ = position - offset_; }
  void write(Tick tick, const JointVector&) noexcept override { exchange(tick); }
  void set_origin(const JointVector& shift) noexcept override { offset_ += shift; }

 private:
  void exchange(Tick tick) noexcept {
    Packet packet{tick, enabled_, {}};
    Eigen::Map<Eigen::VectorXd>(packet.position, count_) = target_;
    ::send(socket_, &packet, sizeof packet, 0);
  }
  /// True: an answer has come. Packets of another length, and doubled or overtaken ones, change nothing.
  bool receive() noexcept {
    bool received = false;
    Packet packet{};
    for (ssize_t size; (size = ::recv(socket_, &packet, sizeof packet, MSG_TRUNC)) >= 0;) {
      if (size != sizeof packet || packet.tick < answered_) continue;
      received = true;
      answered_ = packet.tick;
      shafts_ = Eigen::Map<Eigen::VectorXd>(packet.position, count_);
    }
    return received;
  }

  int count_, socket_;
  bool enabled_ = false;
  sockaddr_in address_;
  JointVector shafts_, target_, offset_;
  Tick answered_ = 0;
};

}  // namespace mrroc
