#include "mrroc/robots/fast_conveyor.hpp"

#include "config/robot_parameters_file.hpp"
#include "mrroc/robots/conveyor.hpp"
#include "robots/conveyor/conveyor_model.hpp"
#include "robots/fast_conveyor/fast_conveyor_model.hpp"

namespace mrroc {

RobotModels load_fast_conveyor() { return load_conveyor(config::robot_file("fast_conveyor", "fast_conveyor.toml")); }

FastConveyor::FastConveyor(Task& task, const std::string& name) : Robot(task, name, load_fast_conveyor()) {}

JointVector FastConveyor::at(double position) { return Conveyor::at(position); }

}  // namespace mrroc
