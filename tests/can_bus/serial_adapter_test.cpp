// Reports of a kernel CAN driver about its controller: the driver of serial line adapters (slcan); the test holds the
// line. tests/can/with_can runs it where that driver exists.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/tty.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <string>

#include "can/bus_error.hpp"
#include "can/socket_bus.hpp"
#include "can_bus/receiving.hpp"

namespace mrroc::can {
namespace {

/// The kernel's interface of an adapter that sends the test's reports.
class SerialAdapter {
 public:
  SerialAdapter() : line_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK)) {
    ::grantpt(line_);
    ::unlockpt(line_);
    port_ = ::open(::ptsname(line_), O_RDWR | O_NOCTTY | O_CLOEXEC);
    const int discipline = N_SLCAN;
    std::array<char, IFNAMSIZ> name{};
    if (::ioctl(port_, TIOCSETD, &discipline) == 0 && ::ioctl(port_, SIOCGIFNAME, name.data()) == 0)
      name_ = name.data();
  }
  ~SerialAdapter() {
    ::close(port_);
    ::close(line_);
  }
  SerialAdapter(const SerialAdapter&) = delete;
  SerialAdapter& operator=(const SerialAdapter&) = delete;

  /// Empty: the kernel has no such driver.
  const std::string& interface() const { return name_; }
  void set(const std::string& upness) const {
    ASSERT_EQ(std::system(("PATH=$PATH:/usr/sbin:/sbin ip link set " + name_ + " " + upness).c_str()), 0);
  }
  bool has_carrier() const { return std::system(("grep -q 1 /sys/class/net/" + name_ + "/carrier").c_str()) == 0; }
  void say(const std::string& line) const {
    ASSERT_EQ(::write(line_, (line + "\r").c_str(), line.size() + 1), static_cast<ssize_t>(line.size() + 1));
  }

 private:
  int line_, port_ = -1;
  std::string name_;
};

TEST(SerialAdapter, KernelReportsItsStatesUpToBusOff) {
  const SerialAdapter adapter;
  ASSERT_FALSE(adapter.interface().empty()) << "this kernel has no slcan; tests/can/with_can provides it";
  adapter.set("up");
  SocketBus bus(adapter.interface());
  bus.filter(std::vector<Filter>{{0x183, 0x7ff}});
  adapter.say("t1832AABB");
  EXPECT_EQ(test::next_frame(bus), (Frame{0x183, {0xaa, 0xbb}}));
  // with its receive and transmit error counters
  for (const auto& [state, error] : {std::pair{"sw000100", BusError::warning},
                                     {"sp000130", BusError::passive},
                                     {"sa000090", BusError::recovered},
                                     {"sb000256", BusError::bus_off}}) {
    adapter.say(state);
    const auto frame = test::next_frame(bus);
    ASSERT_TRUE(frame) << state;
    EXPECT_TRUE(frame->error) << state;
    EXPECT_EQ(bus_error_of(*frame), error) << state << ": " << describe(bus_error_of(*frame));
  }
  EXPECT_FALSE(adapter.has_carrier()) << "the kernel has switched it off";
  adapter.set("down");
  EXPECT_EQ(bus.send({0x203, {}}), Sent::down);
  adapter.set("up");
  EXPECT_TRUE(adapter.has_carrier());
  adapter.say("t1830");
  EXPECT_EQ(test::next_frame(bus), (Frame{0x183, {}}));
  EXPECT_EQ(bus.send({0x203, {}}), Sent::yes);
}

}  // namespace
}  // namespace mrroc::can
