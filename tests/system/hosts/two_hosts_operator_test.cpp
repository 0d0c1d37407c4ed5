// The operator at the runner's machine commands a robot whose EDP is on the other host, while no task commands it.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "cli/operator/socket/run_connection.hpp"
#include "system/hosts/two_hosts.hpp"

namespace mrroc::test::two_hosts_operator_test {
namespace {

using Json = nlohmann::json;
using Arguments = std::map<std::string, std::string>;

constexpr int kStopped = 5;
constexpr double kStep = 0.1;  // rad

class TwoHostsOperated : public TwoHosts {
 protected:
  void SetUp() override {
    TwoHosts::SetUp();
    setenv("MRROC_RUNTIME_DIR", file("runtime").c_str(), 1);
  }
  void TearDown() override { unsetenv("MRROC_RUNTIME_DIR"); }

  /// Starts a run whose task waits for its start, and connects to it.
  cli::RunConnection start_held() {
    start(write(hosts("two", kPatientLink, {}, press())), {"--hold"});
    for (double waited = 0; waited < MrrocRun::kPatience && !run_->has_ended(); waited += 0.05) {
      pause_for(0.05);
      try {
        cli::RunConnection run = cli::RunConnection::to("two");
        if (Json::parse(run.request("status").data).at("task") == "held") return run;
      } catch (const std::runtime_error&) {
        continue;  // it has no socket so far
      }
    }
    throw std::runtime_error("the run is never held: " + output());
  }

  /// The arm's newest state, as the run publishes it to watchers.
  static Json state_of_arm() {
    cli::RunConnection watcher = cli::RunConnection::to("two");
    EXPECT_TRUE(watcher.request("echo", {{"of", "robots"}}).ok());
    for (;;) {
      const std::optional<std::string> line = watcher.next_line(MrrocRun::kPatience);
      if (!line) throw std::runtime_error("the run has ended");
      Json event = Json::parse(*line);
      if (event.value("event", "") == "robot" && event.value("name", "") == "arm") return event;
    }
  }
  /// Waits until the arm's state is so; false when it never is.
  static bool await_arm(const std::function<bool(const Json&)>& holds) {
    for (double waited = 0; waited < 20; waited += 0.05) {
      if (holds(state_of_arm())) return true;
      pause_for(0.05);
    }
    return false;
  }
  static double column() { return state_of_arm().at("joints").at(0).get<double>(); }
  static bool at_rest(const Json& arm) { return std::abs(arm.at("velocity").at(0).get<double>()) < 0.01; }

  void expect_done(cli::RunConnection& run, std::string_view verb, Arguments arguments, std::string_view effect) {
    arguments["robot"] = "arm";
    const cli::VerbReply reply = run.request(verb, arguments);
    EXPECT_TRUE(reply.ok()) << verb << ": " << cli::to_text(reply) << "\n" << output();
    EXPECT_EQ(reply.text, effect) << verb;
  }
};

TEST_F(TwoHostsOperated, RobotOfTheOtherHostTakesEveryOrder) {
  cli::RunConnection run = start_held();
  const double before = column();
  expect_done(run, "step", {{"axis", "column"}, {"distance", "0.1"}}, "the robot has arrived");
  EXPECT_TRUE(await_arm(at_rest));
  EXPECT_NEAR(column(), before + kStep, 0.01);

  expect_done(run, "jog", {{"axis", "column"}, {"velocity", "-0.2"}}, "the robot jogs");
  EXPECT_TRUE(await_arm([&](const Json& arm) {
    return at_rest(arm) && arm.at("joints").at(0).get<double>() < before + kStep - 0.01;
  })) << "it has moved, and brakes without another jog";

  for (int i = 0; i < 3; ++i) expect_done(run, "jog", {{"axis", "1"}, {"velocity", "0.2"}}, "the robot jogs");
  expect_done(run, "hold", {}, "the robot comes to rest");
  EXPECT_TRUE(await_arm(at_rest));

  expect_done(run, "output", {{"output", "3"}, {"value", "1"}}, "the output is set");
  EXPECT_TRUE(await_arm([](const Json& arm) { return (arm.at("outputs").get<unsigned>() & 1U << 3) != 0; }));

  EXPECT_TRUE(run.request("estop").ok());
  EXPECT_TRUE(await_arm([](const Json& arm) { return arm.contains("error") && !arm.at("error").is_null(); }));
  EXPECT_FALSE(run.request("step", {{"robot", "arm"}, {"axis", "column"}, {"distance", "0.1"}}).ok());
  EXPECT_TRUE(run.request("reset").ok());
  expect_done(run, "recover", {}, "the drives are on");
  expect_done(run, "go", {{"posture", "home"}}, "the robot has arrived");

  // the other host need not have received the stop: what follows is refused, or comes after it
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(run.request("estop").ok());
    EXPECT_FALSE(run.request("recover", {{"robot", "arm"}}).ok());
    EXPECT_TRUE(run.request("reset").ok());
    expect_done(run, "recover", {}, "the drives are on");
  }

  EXPECT_TRUE(run.request("stop").ok());
  EXPECT_EQ(run_->wait(), kStopped) << output();
}

TEST_F(TwoHostsOperated, OrdersArriveOverAPoorCable) {
  cli::RunConnection run = start_held();
  cable_->set({.loss = 0.1, .duplicate = 0.1, .reorder = 0.1});
  const double before = column();
  for (int i = 0; i < 5; ++i)
    expect_done(run, "step", {{"axis", "column"}, {"distance", i % 2 == 0 ? "0.1" : "-0.1"}}, "the robot has arrived");
  EXPECT_TRUE(await_arm(at_rest));
  EXPECT_NEAR(column(), before + kStep, 0.01) << "every order is executed once";
  EXPECT_TRUE(run.request("stop").ok());
  EXPECT_EQ(run_->wait(), kStopped) << output();
}

/// Refused with the robot's own reason, as on the runner's machine.
TEST_F(TwoHostsOperated, OrdersAreRefusedWithTheReasonOfTheOtherHost) {
  cli::RunConnection run = start_held();
  const auto refusal = [&run](std::string_view verb, Arguments arguments) {
    arguments["robot"] = "arm";
    const cli::VerbReply reply = run.request(verb, arguments);
    EXPECT_FALSE(reply.ok()) << verb;
    return cli::to_text(reply);
  };
  EXPECT_NE(refusal("jog", {{"axis", "colum"}, {"velocity", "0.1"}}).find("did you mean 'column'?"), std::string::npos);
  const std::string far = refusal("step", {{"axis", "column"}, {"distance", "50"}});
  EXPECT_NE(far.find("arm"), std::string::npos) << far;
  EXPECT_TRUE(run.request("start").ok());
  EXPECT_TRUE(await_arm([](const Json& arm) { return !at_rest(arm); })) << "the task commands it from then on";
  const std::string taken = refusal("step", {{"axis", "column"}, {"distance", "0.1"}});
  EXPECT_NE(taken.find("busy: the task"), std::string::npos) << taken;
  EXPECT_EQ(run_->wait(), 0) << output();
}

}  // namespace
}  // namespace mrroc::test::two_hosts_operator_test
