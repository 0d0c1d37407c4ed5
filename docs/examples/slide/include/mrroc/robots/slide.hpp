#pragma once

#include "mrroc/robot.hpp"

namespace mrroc {

/// The only model, from the parameter file `file` (empty: slide.toml). Throws ConfigurationError for an invalid file.
RobotModels load_slide(const std::filesystem::path& file = {});

/// A carriage on a rail, as a task program declares it: `Slide slide{*this};`. Joint 0: its position on the rail, m.
class Slide : public Robot {
 public:
  explicit Slide(Task& task, const std::string& name = "") : Robot(task, name, "slide", load_slide) {}
};

}  // namespace mrroc
