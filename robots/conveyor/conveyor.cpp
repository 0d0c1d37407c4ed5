#include "mrroc/robots/conveyor.hpp"

#include "robots/conveyor/conveyor_model.hpp"

namespace mrroc {

Conveyor::Conveyor(Task& task, const std::string& name) : Robot(task, name, "conveyor", load_conveyor) {}

JointVector Conveyor::at(double position) { return JointVector::Constant(1, position); }

}  // namespace mrroc
