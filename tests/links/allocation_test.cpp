// Cyclone allocates per message, with malloc; the framework's links must not.

#include <gtest/gtest.h>

#include <functional>

#include "allocations.hpp"
#include "links/exchange/robot_requester.hpp"
#include "links/exchange/robot_responder.hpp"
#include "links/exchange/sensor_requester.hpp"
#include "links/exchange/sensor_responder.hpp"
#include "links/exchange/task_subordinate.hpp"
#include "links/exchange/task_superior.hpp"
#include "links/telemetry/status_publisher.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"

namespace mrroc::links {
namespace {

std::uint64_t allocations_of(const std::function<void()>& action) {
  action();                                          // initialisation
  const std::uint64_t before = test::allocations();  // of all threads: listeners have their own thread
  for (int i = 0; i < 100; ++i) action();
  return test::allocations() - before;
}

TEST(Allocation, CounterCounts) {
  EXPECT_EQ(allocations_of([] { ::operator delete(::operator new(8)); }), 100U);
}

TEST(Allocation, NoneInAnExchangeWithARobot) {
  TestDomain net;
  TestClock clock;
  RobotRequester ecp(net.domain, clock, "t/arm", "arm_edp");
  RobotResponder edp(net.domain, clock, "t/arm", 1000);
  ecp.connect(kPatience);
  RobotCommand command;
  command.joints = command.joint_velocity = JointVector::Zero(8);
  RobotCommand received;
  RobotState state;
  state.joints = state.motors = JointVector::Zero(8);
  std::uint64_t sequence = 0;
  EXPECT_EQ(allocations_of([&] {
              ecp.send(command);
              edp.take(received, sequence);
              edp.reply(state, sequence);
              ecp.receive(state);
            }),
            0U);
}

TEST(Allocation, NoneInSensorTaskAndStatusLinks) {
  TestDomain net;
  TestClock clock;
  SensorResponder vsp(net.domain, clock, "t/wrist", {"arm"}, true);
  SensorRequester arm(net.domain, clock, "t/wrist", "arm", "wrist_vsp", {.published = true});
  TaskSubordinate subordinate(net.domain, clock, "t/arm");
  TaskSuperior superior(net.domain, clock, "t/arm", "arm");
  StatusPublisher publisher(net.domain, "t");
  arm.connect(kPatience);
  superior.connect(kPatience);
  SensorRequest request;
  SensorReading reading;
  Caller caller;
  TaskCommand command;
  TaskStatus status;
  std::uint64_t last_command = 0;
  EXPECT_EQ(allocations_of([&] {
              arm.request({});
              vsp.take(request, caller);
              vsp.reply(reading, caller);
              arm.receive(reading);
              vsp.publish(reading);
              arm.latest(reading);
              superior.send(TaskCommandKind::trigger);
              subordinate.take(command);
              subordinate.report(status);
              superior.take(status, last_command);
              publisher.publish({});
            }),
            0U);
  EXPECT_GT(last_command, 0U);
}

}  // namespace
}  // namespace mrroc::links
