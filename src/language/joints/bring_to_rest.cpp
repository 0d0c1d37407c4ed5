#include "language/joints/bring_to_rest.hpp"

#include "language/macrostep_timing.hpp"
#include "mrroc/errors.hpp"

namespace mrroc {

void bring_to_rest(const std::vector<Robot*>& robots) {
  std::vector<Robot*> moving = robots;
  const auto is_done = [](const Robot* robot) {
    return robot->state().at_rest() || robot->state().error.error_class != ErrorClass::none;
  };
  std::erase_if(moving, [](const Robot* robot) { return robot->state().at_rest(); });
  try {
    while (!moving.empty()) {
      for (Robot* robot : moving) robot->reset_command(CommandKind::hold);
      for (Robot* robot : moving) robot->send();
      for (Robot* robot : moving) robot->receive();
      std::erase_if(moving, is_done);
    }
  } catch (const Error&) {  // the next instruction throws it again
  }
}

}  // namespace mrroc
