#pragma once

#include <string>

#include "cli/robot/robot_verbs.hpp"

namespace mrroc::cli {

/// The report of a robot type or of an arm in a URDF (`report_of`), and the picture of a type at home that the request
/// wants. Throws config::ConfigurationError as arm_of and load_chain_type; SystemError without OpenGL, or when the
/// picture cannot be written. Configuration time only.
std::string show_arm(const ShowRequest& request);

}  // namespace mrroc::cli
