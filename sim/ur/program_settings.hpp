#pragma once

#include <string>
#include <vector>

#include "mrroc/types.hpp"

namespace mrroc::sim::ur {

/// What programs set for good.
struct ProgramSettings {
  double payload = 0;                                        ///< kg
  Eigen::Vector3d payload_centre = Eigen::Vector3d::Zero();  ///< m, in the flange frame
  Pose tool = Pose::Identity();                              ///< tool centre point in the flange frame
  int tool_voltage = 0;                                      ///< V
};

/// Takes the last set_payload, set_tcp and set_tool_voltage with literal arguments out of the text of a program.
void read_settings(const std::string& text, ProgramSettings& settings);

/// The numbers in a list of literals such as "[0.1, -2e-3], a=1.5", from the first character to the end of the line.
std::vector<double> numbers_in(const std::string& text);

}  // namespace mrroc::sim::ur
