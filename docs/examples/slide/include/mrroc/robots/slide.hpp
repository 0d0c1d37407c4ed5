#pragma once

#include "mrroc/robot.hpp"

namespace mrroc {

/// Its only model. Throws ConfigurationError when slide.toml is wrong.
RobotModels load_slide();

/// A carriage on a rail, as a task program declares it: `Slide slide{*this};`. Joint 0 is its place along the rail, m.
class Slide : public Robot {
 public:
  explicit Slide(Task& task, const std::string& name = "") : Robot(task, name, load_slide()) {}
};

}  // namespace mrroc
