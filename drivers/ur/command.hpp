#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "drivers/ur/rtde/value.hpp"
#include "mrroc/signals.hpp"

namespace mrroc::ur {

/// The command to the control script.
enum class ControlMode : std::int32_t {
  hold = 0,  ///< stop, then hold
  position = 1,
  velocity = 2
};

/// The values that the servo thread hands over in one tick.
struct Command {
  std::int32_t sequence = 0;  ///< differs in every tick; without a new one the control script stops the robot
  ControlMode mode = ControlMode::hold;
  rtde::Vector6d position{};  ///< rad
  rtde::Vector6d velocity{};  ///< rad/s
  bool sets_outputs = false;  ///< false: the terminals stay as they are
  ControllerIo outputs;       ///< digital 0 to 15, analogue 0 and 1, V
};

/// Fields of the recipe of set-points, with the input registers from `registers` on.
std::vector<std::string> set_point_fields(int registers);
/// Their values; `values` has as many elements. Allocates nothing.
void write_set_points(const Command& command, std::span<rtde::Value> values) noexcept;

/// Fields of the recipe of the speed slider.
std::vector<std::string> slider_fields();
void write_slider(double fraction, std::span<rtde::Value> values) noexcept;

}  // namespace mrroc::ur
