#include "cli/can/can_scan.hpp"

#include <gtest/gtest.h>

#include "can/hub.hpp"
#include "canopen/sdo_client.hpp"
#include "cli/can/can_nodes.hpp"
#include "cli/processes/child.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::can_scan_test {
namespace {

using namespace canopen;

constexpr std::int64_t kPatience = clock::kSecond / 2;

class CanScan : public testing::Test {
 protected:
  task_test::ScratchFolder folder_;
  can::Hub hub_{folder_ / "bus"};

  Child program(std::vector<std::string> arguments) {
    return {"mrroc", MRROC_BINARY_DIR "/bin/mrroc", std::move(arguments)};
  }
};

TEST_F(CanScan, FindsEveryDrive) {
  const CanNodes nodes(hub_.name());
  const auto bus = can::open_bus(hub_.name());
  // one of them sends heartbeats
  SdoClient(*bus, 20 * clock::kSecond).download(2, kProducerHeartbeat, 20, 2);
  const ScanResult result = scan(*bus, kPatience);
  ASSERT_EQ(result.nodes.size(), 6u);
  EXPECT_EQ(result.error, can::BusError::none);
  for (std::size_t i = 0; i < 6; ++i) {
    const FoundNode& node = result.nodes[i];
    EXPECT_EQ(node.node, i + 1);
    EXPECT_EQ(node.device_type, 0x00020192u);
    EXPECT_EQ(node.name, "\"CiA 402 servo drive\"");
    EXPECT_TRUE(node.vendor && node.product && node.revision && node.serial);
    if (i == 1) {
      EXPECT_EQ(node.state, NmtState::pre_operational);
    }
  }
}

TEST_F(CanScan, FindsANodeThatOnlySendsHeartbeats) {
  const auto bus = can::open_bus(hub_.name()), other = can::open_bus(hub_.name());
  std::atomic<bool> stop{false};
  std::thread beats([&] {
    while (!stop) {
      other->send(heartbeat_frame(9, NmtState::stopped));
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  });
  const ScanResult result = scan(*bus, kPatience);
  stop = true;
  beats.join();
  ASSERT_EQ(result.nodes.size(), 1u);
  EXPECT_EQ(scan_text(result.nodes),
            "node  state    profile    name  vendor  product  revision  serial number\n"
            "9     stopped  no answer  -     -       -        -         -\n");
}

TEST_F(CanScan, QueriesEachNodeOnceAndNothingElse) {
  const auto bus = can::open_bus(hub_.name()), listener = can::open_bus(hub_.name());
  EXPECT_TRUE(scan(*bus, clock::kSecond / 10).nodes.empty());
  for (unsigned node = 1; node <= kMaxNode; ++node) {
    can::Frame frame;
    ASSERT_TRUE(listener->receive(frame, 0));
    EXPECT_EQ(frame, (can::Frame{kSdoRequest + node, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}}));
  }
  can::Frame none;
  EXPECT_FALSE(listener->receive(none, 0));
}

TEST_F(CanScan, PassesOnBusReports) {
  const auto bus = can::open_bus(hub_.name()), other = can::open_bus(hub_.name());
  can::Frame error{0x40, {0, 0, 0, 0, 0, 0, 0, 0}};
  error.error = true;
  other->send(error);
  const ScanResult result = scan(*bus, clock::kSecond / 10);
  EXPECT_EQ(result.error, can::BusError::bus_off);
  EXPECT_TRUE(silence_text("can0", result.error, 0.5)
                  .starts_with("can0: no node has answered within 0.5 s; the bus: bus off: the controller has left the "
                               "bus after too many errors\nLook at\n"));
}

TEST_F(CanScan, TheProgramPrintsATable) {
  const CanNodes nodes(hub_.name());
  Child child = program({"can", "scan", hub_.name()});
  const std::string output = child.wait_for_output();
  EXPECT_EQ(child.exit_code(), 0) << output;
  EXPECT_TRUE(output.starts_with("node  state")) << output;
  EXPECT_NE(output.find("402 (drive)  \"CiA 402 servo drive\"  0x0"), std::string::npos) << output;
  EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 7) << output;
}

TEST_F(CanScan, TheProgramReportsThatNoNodeAnswers) {
  Child child = program({"can", "scan", hub_.name(), "--patience", "0.1"});
  const std::string output = child.wait_for_output();
  EXPECT_EQ(child.exit_code(), 1);
  EXPECT_TRUE(output.starts_with(hub_.name() + ": no node has answered within 0.1 s\nLook at\n")) << output;
}

TEST_F(CanScan, TheProgramRefusesABadInterface) {
  Child child = program({"can", "scan", "nosuchcan"});
  const std::string output = child.wait_for_output();
  EXPECT_EQ(child.exit_code(), 2);
  EXPECT_TRUE(output.starts_with("mrroc: CAN interface 'nosuchcan': ")) << output;
}

}  // namespace
}  // namespace mrroc::cli::can_scan_test
