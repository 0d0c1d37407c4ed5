#pragma once

#include "mrroc/robot.hpp"

namespace mrroc {

/// Its only model, of the parameter file `file`; empty: of slide.toml. Throws ConfigurationError when it is wrong.
RobotModels load_slide(const std::filesystem::path& file = {});

/// A carriage on a rail, as a task program declares it: `Slide slide{*this};`. Joint 0 is its place along the rail, m.
class Slide : public Robot {
 public:
  explicit Slide(Task& task, const std::string& name = "") : Robot(task, name, "slide", load_slide) {}
};

}  // namespace mrroc
