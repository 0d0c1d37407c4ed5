#include "cli/processes/process_plan.hpp"

namespace mrroc::cli {

std::vector<PlannedProcess> plan_processes(const config::Deployment& deployment) {
  std::vector<PlannedProcess> plan;
  if (deployment.sim) plan.push_back({"sim", deployment.sim->program, clock::Part::world, false, deployment.sim->host});
  for (const config::RobotEntry& robot : deployment.robots)
    if (robot.driver.simulated)
      plan.push_back({robot.drives_process(), robot.driver.stand_in, clock::Part::world, false, robot.host});
  for (const config::SensorEntry& sensor : deployment.sensors)
    if (sensor.has_stand_in())
      plan.push_back({sensor.stand_in_process(), sensor.driver->stand_in, clock::Part::world, false, sensor.host});
  for (const config::RobotEntry& robot : deployment.robots) {
    plan.push_back({robot.edp_process(), robot.edp_program, clock::Part::drives, false, robot.host});
  }
  for (const config::SensorEntry& sensor : deployment.sensors) {
    plan.push_back({sensor.name, sensor.vsp_program, clock::Part::task, false, sensor.host});
  }
  for (const config::RobotEntry& robot : deployment.robots)
    plan.push_back({robot.name, robot.program, clock::Part::task, true, robot.host});
  plan.push_back({"mp", deployment.mp.program, clock::Part::task, true});
  return plan;
}

std::vector<std::string> names_of(const std::vector<PlannedProcess>& processes) {
  std::vector<std::string> names;
  names.reserve(processes.size());
  for (const PlannedProcess& process : processes) names.push_back(process.name);
  return names;
}

}  // namespace mrroc::cli
