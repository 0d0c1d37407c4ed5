#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "clock/clock.hpp"
#include "config/deployment.hpp"
#include "links/exchange/robot_operator.hpp"
#include "links/transport/domain.hpp"
#include "mrroc/robot_parameters.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc::cli {

/// The operator's links to all robots of a deployment, and the meaning of orders to them.
class RobotOrders {
 public:
  /// The reply of a robot to an order.
  struct Answer {
    std::string robot;
    std::uint64_t number = 0;
    RobotState state;
  };

  /// Reads the robots' parameter files. Throws ConfigurationError, or as links::Writer.
  RobotOrders(const config::Deployment& deployment, links::Domain& domain, clock::Clock& clock);

  /// Hand-shakes with every EDP that has not answered one, about `timeout` s each at most; before the clock starts.
  /// Throws as links::connect.
  void connect(double timeout);

  /// The number of a robot's axes. Throws std::invalid_argument when there is no such robot. Any thread.
  std::size_t axes(const std::string& name) const { return robot(name).parameters.axes.size(); }
  /// Throws std::invalid_argument when the order is wrong. Any thread.
  void check(const std::string& command, const config::RobotOrder& order) const;
  /// Sends an order that `check` has accepted, and returns its number. `paused`: the task is paused. One thread at a
  /// time.
  std::uint64_t send(const std::string& command, const config::RobotOrder& order, bool paused);
  /// The next reply; false when none has arrived. Main thread.
  bool take(Answer& answer);

 private:
  struct Robot {
    RobotParameters parameters;
    std::unique_ptr<links::RobotOperator> link;
    bool connected = false;
  };

  const Robot& robot(const std::string& name) const;

  std::map<std::string, Robot> robots_;
};

}  // namespace mrroc::cli
