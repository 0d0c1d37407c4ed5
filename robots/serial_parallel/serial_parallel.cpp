#include "mrroc/robots/serial_parallel.hpp"

#include "geometry/tool_down.hpp"
#include "robots/serial_parallel/serial_parallel_model.hpp"

namespace mrroc {

SerialParallel::SerialParallel(Task& task, const std::string& name)
    : Robot(task, name, "serial_parallel", load_serial_parallel) {}

Pose SerialParallel::tool_down(double x, double y, double z) { return mrroc::tool_down(x, y, z); }

}  // namespace mrroc
