#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mrroc::sim {

/// The parts of one of MuJoCo's loading errors.
struct MujocoErrorText {
  std::optional<std::size_t> line;  ///< "line 3", "line = 3", "Line number=3"
  std::optional<std::size_t> id;    ///< "id = 3": number of the object in its section
  std::string text;                 ///< in one line, without line and column
};

MujocoErrorText parse_mujoco_error(std::string_view message);

}  // namespace mrroc::sim
