#include "cli/robot/type/regulator_lines.hpp"

#include <spdlog/fmt/fmt.h>

#include <numbers>

#include "config/axis_file.hpp"
#include "regulation/regulator_design.hpp"
#include "regulation/servo_loop.hpp"

namespace mrroc::cli {

namespace {

std::string line_of(const AxisParameters& axis, double gear) {
  const auto at = [&axis](double inertia) {
    return regulation::ServoLoop(axis, inertia, config::kRegulatorPeriod).margins();
  };
  const auto degrees = [](double angle) { return angle * 180 / std::numbers::pi; };
  const double least = regulation::shaft_inertia(axis, axis.inertia_min, gear);
  const double greatest = regulation::shaft_inertia(axis, axis.inertia_max, gear);
  const double design = regulation::design_inertia(axis, gear);
  const regulation::LoopMargins margins = at(design);
  return fmt::format(
      "{:<28} {:.1f} Hz, phase margin {:.0f} deg, {:.0f} and {:.0f} at the inertia {:.3g} and {:.3g} kg m2, stable "
      "from "
      "{:.2g} to {:.2g}\n",
      axis.name + ", regulator", margins.crossover, degrees(margins.phase_margin), degrees(at(least).phase_margin),
      degrees(at(greatest).phase_margin), least, greatest, design / margins.gain_increase,
      design / margins.gain_decrease);
}

}  // namespace

std::string regulator_lines(const RobotModel& model) {
  std::string text;
  const RobotParameters& parameters = model.parameters();
  const JointVector gears = model.transmission(parameters.home).diagonal();
  for (std::size_t i = 0; i < parameters.axes.size(); ++i)
    if (parameters.axes[i].regulator_bandwidth > 0)
      text += line_of(parameters.axes[i], gears[static_cast<Eigen::Index>(i)]);
  return text;
}

}  // namespace mrroc::cli
