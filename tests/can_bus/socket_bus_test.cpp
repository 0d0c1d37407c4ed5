// Runs where the kernel's interfaces can0 and can1 exist: tests/can/with_can.
#include "can/socket_bus.hpp"

#include <gtest/gtest.h>
#include <linux/can/error.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <memory>
#include <stdexcept>

#include "can_bus/receiving.hpp"

namespace mrroc::can {
namespace {

using test::frames_until;
using test::next_frame;

/// Sets an interface as `ip link set` would.
void set_interface(const std::string& name, unsigned long what, auto&& change) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  ifreq request{};
  name.copy(request.ifr_name, IFNAMSIZ - 1);
  ::ioctl(socket, SIOCGIFFLAGS, &request);
  change(request);
  ASSERT_EQ(::ioctl(socket, what, &request), 0) << name;
  ::close(socket);
}

void set_up(const std::string& name, bool up) {
  set_interface(name, SIOCSIFFLAGS, [up](ifreq& request) {
    request.ifr_flags = static_cast<short>(up ? request.ifr_flags | IFF_UP : request.ifr_flags & ~IFF_UP);
  });
}

void set_largest(const std::string& name, int bytes) {
  set_up(name, false);
  set_interface(name, SIOCSIFMTU, [bytes](ifreq& request) { request.ifr_mtu = bytes; });
  set_up(name, true);
}

std::string refusal(const std::string& interface) {
  try {
    const SocketBus bus(interface);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(SocketBus, CarriesFramesInBothDirections) {
  SocketBus one("can0"), two("can0"), elsewhere("can1");
  Frame remote{0x703, {}};
  remote.remote = true;
  for (const Frame& frame : {Frame{0x000, {1, 0}}, Frame{0x080, {}}, Frame{0x7ff, {1, 2, 3, 4, 5, 6, 7, 8}}, remote}) {
    ASSERT_EQ(one.send(frame), Sent::yes);
    EXPECT_EQ(next_frame(two), frame);
    ASSERT_EQ(two.send(frame), Sent::yes);
    EXPECT_EQ(next_frame(one), frame) << "and none of its own frames";
  }
  Frame none;
  EXPECT_FALSE(elsewhere.receive(none, 0)) << "another bus";
  EXPECT_FALSE(one.receive(none, clock::monotonic_ns() + 1'000'000));
}

TEST(SocketBus, FiltersLetErrorFramesThrough) {
  SocketBus sender("can0"), receiver("can0");
  receiver.filter(std::vector<Filter>{{0x183, 0x7ff}, {0x700, 0x780}});
  Frame error;
  error.error = true;
  error.id = CAN_ERR_BUSOFF;
  error.size = 8;
  for (const Frame& frame : {Frame{0x182, {}}, Frame{0x183, {1}}, Frame{0x080, {}}, error, Frame{0x77f, {2}}})
    ASSERT_EQ(sender.send(frame), Sent::yes);
  EXPECT_EQ(next_frame(receiver), (Frame{0x183, {1}}));
  EXPECT_EQ(next_frame(receiver), error);
  EXPECT_EQ(next_frame(receiver), (Frame{0x77f, {2}}));
  receiver.filter({});
  sender.send({0x183, {}});
  sender.send(error);
  EXPECT_EQ(next_frame(receiver), error) << "no filter: nothing else";
}

TEST(SocketBus, IsDownWithItsInterfaceAndComesBackWithIt) {
  SocketBus sender("can1"), receiver("can1");
  set_up("can1", false);
  EXPECT_EQ(sender.send({1, {}}), Sent::down);
  Frame none;
  EXPECT_FALSE(receiver.receive(none, clock::monotonic_ns() + 1'000'000));
  set_up("can1", true);
  EXPECT_EQ(sender.send({2, {}}), Sent::yes);
  EXPECT_EQ(next_frame(receiver)->id, 2u);
}

TEST(SocketBus, CarriesFramesOfCanFdWhereTheInterfaceDoes) {
  set_largest("can1", 16);
  SocketBus classical("can1");
  EXPECT_FALSE(classical.carries_fd());
  set_largest("can1", 72);
  SocketBus sender("can1"), receiver("can1");
  EXPECT_TRUE(sender.carries_fd());
  Frame frame;
  frame.id = 0x123;
  frame.fd = frame.bit_rate_switch = true;
  frame.size = 64;
  for (std::size_t i = 0; i < frame.size; ++i) frame.data[i] = static_cast<std::uint8_t>(i);
  EXPECT_EQ(sender.send(frame), Sent::yes);
  EXPECT_EQ(sender.send({0x124, {1, 2}}), Sent::yes);
  EXPECT_EQ(next_frame(receiver), frame);
  EXPECT_EQ(next_frame(receiver), (Frame{0x124, {1, 2}})) << "classical frames stay classical";
  EXPECT_EQ(classical.send(frame), Sent::down) << "its socket is open for classical frames";
  EXPECT_EQ(next_frame(classical), (Frame{0x124, {1, 2}})) << "and receives only those";
}

TEST(SocketBus, ReportsInvalidInterfaces) {
  const std::string not_there = "is not there, expected the name of a CAN interface (ip -brief link show type can)";
  for (const std::string name : {"can9", "", "a_name_that_is_longer_than_any"})
    EXPECT_EQ(refusal(name), "CAN interface '" + name + "': " + not_there);
  EXPECT_EQ(refusal("lo"), "CAN interface 'lo': is not a CAN interface");
  set_up("can1", false);
  EXPECT_EQ(refusal("can1"),
            "CAN interface 'can1': is down, expected it up: ip link set can1 up type can bitrate 1000000");
  set_up("can1", true);
  EXPECT_EQ(refusal("can1"), "");
}

}  // namespace
}  // namespace mrroc::can
