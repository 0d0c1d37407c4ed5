#include "cli/operator/robot_orders.hpp"

#include <stdexcept>
#include <vector>

#include "config/entries/robot_orders.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::cli {

namespace {

constexpr std::uint8_t kTaskPaused = 1;  // edp::OperatorMotion::kTaskPaused

}  // namespace

RobotOrders::RobotOrders(const config::Deployment& deployment, links::Domain& domain, clock::Clock& clock) {
  for (const config::RobotEntry& entry : deployment.robots) {
    Robot& robot = robots_[entry.name];
    robot.parameters = config::parameters_of(entry);
    robot.link = std::make_unique<links::RobotOperator>(domain, clock, deployment.name + "/" + entry.name + "/operator",
                                                        entry.edp_process());
  }
}

void RobotOrders::connect(double timeout) {
  for (auto& [name, robot] : robots_) {
    if (robot.connected) continue;
    robot.link->connect(timeout);
    robot.connected = true;
  }
}

const RobotOrders::Robot& RobotOrders::robot(const std::string& name) const {
  const auto found = robots_.find(name);
  if (found != robots_.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, robot] : robots_) names.push_back(known);
  throw std::invalid_argument("robot: " + config::in_quotes(name) + " is unknown, expected " +
                              config::alternatives(names));
}

void RobotOrders::check(const std::string& command, const config::RobotOrder& order) const {
  config::command_of(command, order, robot(order.robot).parameters);
}

std::uint64_t RobotOrders::send(const std::string& command, const config::RobotOrder& order, bool paused) {
  RobotCommand sent = config::command_of(command, order, robot(order.robot).parameters);
  if (paused && (command == "jog" || command == "step" || command == "go")) sent.choice = kTaskPaused;
  return robots_.at(order.robot).link->send(sent);
}

bool RobotOrders::take(Answer& answer) {
  for (auto& [name, robot] : robots_) {
    if (!robot.link->take(answer.state, answer.number)) continue;
    answer.robot = name;
    return true;
  }
  return false;
}

}  // namespace mrroc::cli
