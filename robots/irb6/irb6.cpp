#include "mrroc/robots/irb6.hpp"

#include "robots/irb6/irb6_model.hpp"

namespace mrroc {

Irb6::Irb6(Task& task, const std::string& name) : Robot(task, name, load_irb6()) {}

}  // namespace mrroc
