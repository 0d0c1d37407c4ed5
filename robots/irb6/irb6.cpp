#include "mrroc/robots/irb6.hpp"

#include "geometry/tool_down.hpp"
#include "robots/irb6/irb6_model.hpp"

namespace mrroc {

Irb6::Irb6(Task& task, const std::string& name) : Robot(task, name, "irb6", load_irb6) {}

Pose Irb6::tool_down(double x, double y, double z) { return mrroc::tool_down(x, y, z); }

}  // namespace mrroc
