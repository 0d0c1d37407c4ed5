#include "mrroc/robots/irb6_track.hpp"

#include "mrroc/robots/irb6.hpp"
#include "robots/irb6_track/irb6_track_model.hpp"

namespace mrroc {

Irb6Track::Irb6Track(Task& task, const std::string& name) : Robot(task, name, "irb6_track", load_irb6_track) {}

Pose Irb6Track::tool_down(double x, double y, double z) { return Irb6::tool_down(x, y, z); }

}  // namespace mrroc
