#include "mrroc/robots/polycrank.hpp"

#include "geometry/tool_down.hpp"
#include "robots/polycrank/polycrank_model.hpp"

namespace mrroc {

Polycrank::Polycrank(Task& task, const std::string& name) : Robot(task, name, "polycrank", load_polycrank) {}

Pose Polycrank::tool_down(double x, double y, double z) { return mrroc::tool_down(x, y, z); }

}  // namespace mrroc
