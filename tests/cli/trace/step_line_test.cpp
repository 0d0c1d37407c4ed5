#include "cli/trace/step_line.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "cli/trace/malformed.hpp"
#include "cli/trace/step_of_line.hpp"
#include "cli/trace/trace_steps.hpp"
#include "messages/cdr_reader.hpp"

namespace mrroc::cli::trace::step_line_test {
namespace {

constexpr std::uint64_t kPeriod = 2'000'000;  // ns

/// A step of the example with a robot, a command, and a sensor.
messages::mrroc_msgs::Step example() {
  const TraceSteps trace = example_trace();
  for (const Item& item : trace.items) {
    const Line* line = std::get_if<Line>(&item);
    if (line != nullptr && !line->robots.empty() && !line->sensors.empty() && line->robots[0].command)
      return to_message(*line, kPeriod);
  }
  throw std::logic_error("the example has no such step");
}

TEST(StepLine, HasEveryFieldToTheLastBit) {
  const TraceSteps trace = example_trace();
  for (const Item& item : trace.items) {
    const Line* line = std::get_if<Line>(&item);
    if (line == nullptr) continue;
    const messages::mrroc_msgs::Step message = to_message(*line, kPeriod);
    const Line read = to_line(messages::from_cdr<messages::mrroc_msgs::Step>(messages::to_cdr(message)));
    EXPECT_EQ(to_message(read, kPeriod), message);
  }
}

TEST(StepLine, RefusesWrongValuesWithFieldAndExpectation) {
  using Step = messages::mrroc_msgs::Step;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::function<void(Step&)>, std::string>> cases{
      {[](Step& step) { step.process = ""; }, "process: '', expected a name"},
      {[](Step& step) { step.ending = 8; }, "ending: '8', expected 0 to 7"},
      {[](Step& step) { step.robots[0].name = ""; }, "robot.name: '', expected a name"},
      {[](Step& step) { step.robots[0].coordination = 3; }, "robot.coordination: '3', expected 0 to 2"},
      {[](Step& step) { step.robots[0].error_class = 4; }, "robot.error_class: '4', expected 0 to 3"},
      {[kNan](Step& step) { step.robots[0].joints[0] = kNan; }, "robot.joints: 'nan', expected finite numbers"},
      {[](Step& step) { step.robots[0].desired_joints.push_back(0); }, "robot.desired_joints: '"},
      {[](Step& step) { step.robots[0].pose.orientation.w += 1; }, "expected a quaternion of length 1"},
      {[](Step& step) {
         step.robots[0].desired_pose.orientation = {0, 0, 0, 2};
       },
       "robot.desired_pose: '2.000000'"},
      {[kNan](Step& step) { step.robots[0].pose.position.x = kNan; }, "robot.pose: 'nan', expected finite numbers"},
      {[](Step& step) {
         step.robots[0].wrench = {1, 2};
       },
       "robot.wrench: '2 numbers', expected 6 numbers"},
      {[kNan](Step& step) { step.robots[0].lost = kNan; }, "robot.lost: 'nan', expected finite numbers"},
      {[](Step& step) { step.robots[0].command[0].kind = 9; }, "command.kind: '9', expected 0 to 8"},
      {[](Step& step) { step.robots[0].command[0].interpolation = 3; }, "command.interpolation: '3', expected 0 to 2"},
      {[](Step& step) {
         step.robots[0].command[0].kind = 1;
         step.robots[0].command[0].target = {1};
       },
       "command.target: '1 numbers', expected 0 numbers"},
      {[](Step& step) {
         step.robots[0].command[0].kind = 7;
         step.robots[0].command[0].target = {1, 2};
       },
       "command.target: '2 numbers', expected 12 numbers"},
      {[](Step& step) {
         step.robots[0].command[0].kind = 7;
         step.robots[0].command[0].target = std::vector<double>(12);
         step.robots[0].command[0].behaviour = "ug";
       },
       "command.behaviour: 'ug', expected 6 letters"},
      {[](Step& step) { step.sensors[0].name = ""; }, "sensor.name: '', expected a name"},
      {[](Step& step) { step.sensors[0].period = 0; }, "sensor.period: '0', expected at least 1"},
      {[](Step& step) { step.sensors[0].mode = 3; }, "sensor.mode: '3', expected 0 to 2"},
      {[](Step& step) { step.sensors[0].error_class = 9; }, "sensor.error_class: '9', expected 0 to 3"},
  };
  for (const auto& [change, expected] : cases) {
    Step step = example();
    change(step);
    try {
      to_line(step);
      ADD_FAILURE() << expected;
    } catch (const Malformed& error) {
      EXPECT_NE(std::string{error.what()}.find(expected), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace mrroc::cli::trace::step_line_test
