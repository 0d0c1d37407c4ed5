// The sizes in the tables of Universal Robots, by which clients tell the versions apart.
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "sim/ur/realtime_message.hpp"
#include "sim/ur/robot_state_message.hpp"

namespace mrroc::sim::ur::state_messages_test {
namespace {

using mrroc::ur::rtde::ControllerVersion;
using mrroc::ur::rtde::WireReader;

VirtualController controller(const ControllerVersion& version) {
  return {{.powered = true, .version = version}, std::make_unique<ExactJoints>(Six{0.1, 0, 0, 0, 0, 0})};
}

struct Version {
  ControllerVersion version;
  std::size_t realtime, robot_mode;
};

class OfEachVersion : public testing::TestWithParam<Version> {};

TEST_P(OfEachVersion, TheRealTimePackageHasItsSizeAndItsJoints) {
  const auto bytes = realtime_message(controller(GetParam().version));
  ASSERT_EQ(bytes.size(), GetParam().realtime);
  WireReader reader(bytes);
  EXPECT_EQ(reader.take<std::uint32_t>(), bytes.size());
  reader.take_bytes(31 * sizeof(double));
  EXPECT_EQ(reader.take<double>(), 0.1) << "actual position of the first joint";
}

TEST_P(OfEachVersion, TheStateConsistsOfItsParts) {
  const auto bytes = robot_state_message(controller(GetParam().version));
  WireReader reader(bytes);
  ASSERT_EQ(reader.take<std::uint32_t>(), bytes.size());
  EXPECT_EQ(reader.take<std::uint8_t>(), 16);
  std::map<int, std::size_t> sizes;
  while (reader.ok() && !reader.complete()) {
    const auto size = reader.take<std::uint32_t>();
    const auto kind = reader.take<std::uint8_t>();
    sizes[kind] = size;
    ASSERT_GE(size, 5u);
    reader.take_bytes(size - 5);
  }
  EXPECT_TRUE(reader.complete());
  const std::map<int, std::size_t> expected{{0, GetParam().robot_mode}, {1, 251}, {2, 37}, {3, 74}, {4, 101}, {7, 61}};
  EXPECT_EQ(sizes, expected);
}

INSTANTIATE_TEST_SUITE_P(StateMessages, OfEachVersion,
                         testing::Values(Version{{3, 4, 0, 0}, 1060, 46}, Version{{3, 15, 0, 0}, 1108, 47},
                                         Version{{5, 4, 0, 0}, 1116, 47}, Version{{5, 11, 0, 0}, 1220, 47}));

}  // namespace
}  // namespace mrroc::sim::ur::state_messages_test
