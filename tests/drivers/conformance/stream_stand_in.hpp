#pragma once

#include <arpa/inet.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "docs/examples/stream/packet.hpp"
#include "mrroc/testing/driver.hpp"

namespace mrroc::driver_test {

/// The controller of docs/examples/stream on a socket of loopback, with every trouble.
class StreamStandIn final : public StandIn {
 public:
  StreamStandIn() : socket_(::socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in here{AF_INET, 0, {htonl(INADDR_LOOPBACK)}, {}};
    socklen_t size = sizeof here;
    if (::bind(socket_, reinterpret_cast<sockaddr*>(&here), size) != 0 ||
        ::getsockname(socket_, reinterpret_cast<sockaddr*>(&here), &size) != 0)
      throw std::runtime_error("no UDP socket on loopback");
    port_ = ntohs(here.sin_port);
  }
  ~StreamStandIn() override {
    stop();
    ::close(socket_);
  }
  /// Also the defect of the driver `bad` that the environment names.
  std::string keys() const override {
    const char* const defect = std::getenv("MRROC_TEST_DEFECT");
    return "port = " + std::to_string(port_) + (defect != nullptr ? std::string("\ndefect = \"") + defect + "\"" : "");
  }
  void start(const JointVector& shafts) override {
    stop();
    for (auto& each : troubles_) each = false;
    state_ = {};
    axes_ = shafts.size();
    for (Eigen::Index i = 0; i < axes_; ++i) state_.position[i] = shafts[i];
    end_ = false;
    thread_ = std::thread([this] { serve(); });
  }
  void stop() override {
    end_ = true;
    if (thread_.joinable()) thread_.join();
    Packet old;
    while (::recv(socket_, &old, sizeof old, MSG_DONTWAIT) >= 0) {
    }
    waiting_.clear();
  }
  /// Waits for the answer to the tick before: its time is that of the driver's packets.
  void advance(Tick) override {
    const std::uint64_t before = std::exchange(served_before_, served_.load());
    for (int i = 0; i < 100 && served_ == before; ++i) ::usleep(20);
  }
  bool simulated_time() const override { return true; }
  JointVector shafts() override {
    const std::lock_guard lock(mutex_);
    return Eigen::Map<const Eigen::VectorXd>(state_.position, axes_);
  }
  bool has(Trouble trouble) const override {
    return trouble != Trouble::no_power && trouble != Trouble::drive_fault && trouble != Trouble::restart;
  }
  void set(Trouble trouble, bool on) override { troubles_[static_cast<std::size_t>(trouble)] = on; }

 private:
  bool on(Trouble trouble) const { return troubles_[static_cast<std::size_t>(trouble)]; }

  void serve() {
    while (!end_) {
      pollfd ready{socket_, POLLIN, 0};
      if (::poll(&ready, 1, 20) != 1) continue;
      Packet order{};
      socklen_t size = sizeof there_;
      if (::recvfrom(socket_, &order, sizeof order, 0, reinterpret_cast<sockaddr*>(&there_), &size) != sizeof order)
        continue;
      if (const Packet packet = obey(order); !on(Trouble::silence)) answer(packet);
      ++served_;
    }
  }

  Packet obey(const Packet& order) {
    const std::lock_guard lock(mutex_);
    for (Eigen::Index i = 0; i < axes_ && order.enabled != 0; ++i) state_.position[i] = order.position[i];
    state_.tick = order.tick;
    Packet answer = state_;
    if (on(Trouble::not_finite)) answer.position[0] = std::numeric_limits<double>::quiet_NaN();
    if (on(Trouble::jump)) answer.position[0] += 5;
    return answer;
  }

  void answer(const Packet& packet) {
    if (on(Trouble::loss) && packet.tick % 5 == 0) return;
    waiting_.push_back(packet);
    if (on(Trouble::lateness) && waiting_.size() <= 3) return;
    while (!waiting_.empty()) {
      for (int i = 0; i < (on(Trouble::doubling) ? 2 : 1); ++i) send(&waiting_.front(), sizeof packet);
      waiting_.pop_front();
      if (on(Trouble::lateness)) break;
    }
    if (!on(Trouble::garbage)) return;
    std::array<unsigned char, sizeof packet + 1> bytes{};
    for (std::size_t length = 0; length <= bytes.size(); length += 24) {
      for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(seed_ = seed_ * 1664525 + 1013904223);
      send(bytes.data(), length == sizeof packet ? length + 1 : length);
    }
  }
  void send(const void* data, std::size_t size) {
    ::sendto(socket_, data, size, 0, reinterpret_cast<const sockaddr*>(&there_), sizeof there_);
  }

  int socket_;
  std::uint16_t port_ = 0;
  std::thread thread_;
  std::atomic<bool> end_{false};
  std::array<std::atomic<bool>, 10> troubles_{};
  std::atomic<std::uint64_t> served_{0};
  std::uint64_t served_before_ = 0;
  std::mutex mutex_;
  Packet state_{};
  Eigen::Index axes_ = 0;
  sockaddr_in there_{};
  std::deque<Packet> waiting_;
  std::uint32_t seed_ = 1;
};

}  // namespace mrroc::driver_test
