// Against a simulated controller on loopback ports. Nothing here depends on how long a period takes.
#include "drivers/ur/wrench/wrench_client.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "allocations.hpp"
#include "clock/wall/monotonic.hpp"
#include "drivers/ur/ur_rig.hpp"

namespace mrroc::ur::wrench_client_test {
namespace {

using testing::HasSubstr;

/// A simulated controller whose flange carries this load, in its own frame.
class LoadedController {
 public:
  explicit LoadedController(const Wrench& load, const ControllerServers::Options& options = free_ports())
      : servers(options, loaded(load)) {}

  WrenchOptions client_options() const { return {"127.0.0.1", servers.ports().rtde, 0, 0.05, 30}; }
  Wrench load_of(WrenchClient& client) const {
    const MeasuredWrench& newest = client.newest();
    return load_on_sensor(newest.package, newest.point, Pose::Identity());
  }

  ControllerServers servers;

 private:
  static std::unique_ptr<ExactJoints> loaded(const Wrench& load) {
    auto joints = std::make_unique<ExactJoints>(Six{0, -1.5, 1.5, -1.5, -1.5, 0});
    joints->set_load(load);
    return joints;
  }
};

const Wrench kLoad = (Wrench() << 1, -2, -30, 0.1, 0.2, -0.3).finished();

bool await(const std::function<bool()>& condition) {
  for (int i = 0; i < 60000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

class OfBothSeries : public testing::TestWithParam<std::uint32_t> {};

TEST_P(OfBothSeries, MeasuresTheLoadOnTheFlange) {
  ControllerServers::Options options = free_ports();
  options.controller.version.major = GetParam();
  options.controller.version.minor = 15;
  options.controller.powered = true;
  LoadedController controller(kLoad, options);
  controller.servers.with([](VirtualController& c) { c.start_program("set_tcp(p[0.1, 0, 0.2, 0, 0.5, 0])"); });
  WrenchClient client(controller.client_options());
  ASSERT_TRUE(await([&] { return client.newest().package.offset.translation().z() == 0.2; }));
  EXPECT_LT((controller.load_of(client) - kLoad).norm(), 1e-9) << controller.load_of(client).transpose();
}

INSTANTIATE_TEST_SUITE_P(WrenchClient, OfBothSeries, testing::Values(3, 5));

TEST(WrenchClient, ThePayloadsWeightIsTakenOut) {
  ControllerServers::Options options = free_ports();
  options.controller.powered = true;
  LoadedController controller(Wrench::Zero(), options);
  controller.servers.with([](VirtualController& c) { c.start_program("set_payload(2, [0, 0, 0.1])"); });
  WrenchClient client(controller.client_options());
  ASSERT_TRUE(await([&] { return controller.load_of(client).norm() > 1; }));
  // nothing hangs there: 2 kg are missing
  EXPECT_NEAR(client.newest().package.force[2], 2 * 9.81, 1e-9);
}

TEST(WrenchClient, SeveralClientsHaveTheirOwnFieldsAndFrequencies) {
  LoadedController controller(kLoad);
  WrenchOptions slow = controller.client_options();
  slow.frequency = 50;
  slow.timeout = 5;
  WrenchOptions fast = controller.client_options();
  fast.timeout = 5;
  WrenchClient first(slow), second(fast);
  RtdeConnection third({"127.0.0.1", controller.servers.ports().rtde, 125, 30});
  third.open({"actual_q", "timestamp"});
  third.start();
  ASSERT_TRUE(await([&] { return first.counters().packages >= 20 && second.counters().packages >= 200; }));
  EXPECT_EQ(controller.servers.rtde_clients(), 3u);
  EXPECT_LT((controller.load_of(first) - kLoad).norm(), 1e-9);
  EXPECT_LT((controller.load_of(second) - kLoad).norm(), 1e-9);
  ASSERT_TRUE(third.wait_readable(clock::monotonic_ns() + 30 * clock::kSecond));
  const auto* const values = third.next();
  ASSERT_NE(values, nullptr);
  EXPECT_EQ(std::get<rtde::Vector6d>((*values)[0])[1], -1.5);
  EXPECT_EQ(first.counters().lost + second.counters().lost, 0u);
  EXPECT_EQ(first.counters().connections + second.counters().connections, 2u);
}

TEST(WrenchClient, CountsLostAndDoubledPackages) {
  LoadedController controller(kLoad);
  WrenchOptions options = controller.client_options();
  options.timeout = 5;
  WrenchClient client(options);
  controller.servers.lose(3);
  EXPECT_TRUE(await([&] { return client.counters().lost == 3; }));
  controller.servers.repeat(2);
  EXPECT_TRUE(await([&] { return client.counters().doubled == 2; }));
  EXPECT_THAT(disturbances(client.counters()), HasSubstr("3 lost"));
  EXPECT_THAT(disturbances(client.counters()), HasSubstr("2 doubled"));
  EXPECT_EQ(disturbances({}), "");
}

TEST(WrenchClient, ConnectsAgain) {
  LoadedController controller(kLoad);
  WrenchClient client(controller.client_options());
  controller.servers.cut();
  EXPECT_TRUE(await([&] { return client.counters().connections >= 2; }));
  const std::int64_t before = client.newest().arrival_ns;
  EXPECT_TRUE(await([&] { return client.newest().arrival_ns > before; }));
  controller.servers.send_garbage();
  EXPECT_TRUE(await([&] { return client.counters().connections >= 3; }));
  EXPECT_THAT(disturbances(client.counters()), HasSubstr("reconnections"));
}

TEST(WrenchClient, NamesAControllerThatIsNotThere) {
  WrenchOptions options;
  {
    const LoadedController controller(kLoad);
    options = controller.client_options();
  }
  options.start_timeout = 0.3;
  std::string text;
  try {
    const WrenchClient client(options);
  } catch (const ConnectionError& error) {
    text = error.what();
  }
  EXPECT_THAT(text, HasSubstr("127.0.0.1:" + std::to_string(options.port)));
  EXPECT_THAT(text, HasSubstr("refused"));
}

TEST(WrenchClient, TheNewestAllocatesNothing) {
  LoadedController controller(kLoad);
  WrenchClient client(controller.client_options());
  const std::uint64_t before = test::thread_allocations();
  for (int i = 0; i < 1000; ++i) controller.load_of(client);
  EXPECT_EQ(test::thread_allocations(), before);
}

}  // namespace
}  // namespace mrroc::ur::wrench_client_test
