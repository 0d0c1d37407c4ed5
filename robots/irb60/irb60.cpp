#include "mrroc/robots/irb60.hpp"

#include "config/robot_files.hpp"
#include "mrroc/robots/irb6.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "robots/irb60/irb60_model.hpp"

namespace mrroc {

RobotModels load_irb60(const std::filesystem::path& file) { return load_irb6(config::parameter_file("irb60", file)); }

Irb60::Irb60(Task& task, const std::string& name) : Robot(task, name, "irb60", load_irb60) {}

Pose Irb60::tool_down(double x, double y, double z) { return Irb6::tool_down(x, y, z); }

}  // namespace mrroc
