#include "cli/process_plan.hpp"

#include "config/resources.hpp"

namespace mrroc::cli {

std::vector<PlannedProcess> plan_processes(const config::Deployment& deployment) {
  const std::filesystem::path programs = config::program_directory();
  std::vector<PlannedProcess> plan;
  if (deployment.sim) plan.push_back({"sim", programs / "mrroc_sim", false});
  for (const config::RobotEntry& robot : deployment.robots) {
    plan.push_back({robot.name + "_edp", programs / (robot.type + "_edp"), false});
  }
  for (const config::SensorEntry& sensor : deployment.sensors) {
    plan.push_back({sensor.name, programs / (sensor.type + "_vsp"), false});
  }
  for (const config::RobotEntry& robot : deployment.robots) plan.push_back({robot.name, robot.program, true});
  plan.push_back({"mp", deployment.mp.program, true});
  return plan;
}

}  // namespace mrroc::cli
