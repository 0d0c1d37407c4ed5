#include "mrroc/robots/irb6_five_axis.hpp"

#include "mrroc/robots/irb6.hpp"
#include "robots/irb6_five_axis/irb6_five_axis_model.hpp"

namespace mrroc {

Irb6FiveAxis::Irb6FiveAxis(Task& task, const std::string& name)
    : Robot(task, name, "irb6_five_axis", load_irb6_five_axis) {}

Pose Irb6FiveAxis::tool_down(double x, double y, double z) { return Irb6::tool_down(x, y, z); }

}  // namespace mrroc
