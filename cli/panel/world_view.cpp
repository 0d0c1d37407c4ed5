#include "cli/panel/world_view.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/pictures/world_event.hpp"
#include "config/robot_parameters_file.hpp"
#include "config/table.hpp"
#include "sim/simulation.hpp"

namespace mrroc::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kPositionsOfJoint[] = {7, 4, 1, 1};  // free, ball, slide, hinge
constexpr double kPerMetre = 1e5;                  // resolution of the numbers that are sent

std::vector<double> numbers(const Json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end() || !found->is_array()) return {};
  std::vector<double> values;
  for (const Json& value : *found) values.push_back(value.is_number() ? value.get<double>() : 0);
  return values;
}

void append_poses(const mjModel& model, const mjData& data, Json& array) {
  const auto add = [&array](double value) { array.push_back(std::round(value * kPerMetre) / kPerMetre); };
  for (int i = 0; i < model.nbody; ++i) {
    for (int j = 0; j < 3; ++j) add(data.xpos[3 * i + j]);
    for (const int j : {1, 2, 3, 0}) add(data.xquat[4 * i + j]);
  }
}

}  // namespace

WorldView::WorldView(const config::Deployment& deployment)
    : model_(sim::load_model(sim::compose_all(deployment))),
      actual_(sim::make_data(*model_)),
      desired_(sim::make_data(*model_)) {
  for (const config::RobotEntry& robot : deployment.robots) {
    const RobotParameters parameters = config::read_robot_parameters(config::Table::load(robot.files().parameters));
    std::vector<std::string> joints;
    for (const AxisParameters& axis : parameters.axes) joints.push_back(axis.name);
    ViewedRobot viewed{sim::DrivenJoints(*model_, robot.name, joints), robot.in_world()};
    viewed.joints.place(*model_, *actual_, parameters.home);
    viewed.joints.place(*model_, *desired_, parameters.home);
    robots_.emplace(robot.name, std::move(viewed));
  }
  if (!deployment.sim) return;
  const sim::Model world = sim::load_model(sim::compose(deployment));
  world_positions_ = world->nq;
  world_mocaps_ = world->nmocap;
  for (int i = 0; i < world->njnt; ++i) {
    const std::string name = world->names + world->name_jntadr[i];
    const int here = mj_name2id(model_.get(), mjOBJ_JOINT, name.c_str());
    if (here < 0 || model_->jnt_type[here] != world->jnt_type[i]) continue;
    positions_.push_back({world->jnt_qposadr[i], model_->jnt_qposadr[here], kPositionsOfJoint[world->jnt_type[i]],
                          robots_.contains(name.substr(0, name.find('/')))});
  }
  for (int i = 0; i < world->nbody; ++i) {
    const int here = mj_name2id(model_.get(), mjOBJ_BODY, world->names + world->name_bodyadr[i]);
    if (world->body_mocapid[i] >= 0 && here >= 0 && model_->body_mocapid[here] >= 0)
      mocaps_.emplace_back(world->body_mocapid[i], model_->body_mocapid[here]);
  }
}

void WorldView::take(std::string_view event) {
  const Json json = Json::parse(event, nullptr, false);
  if (!json.is_object()) return;
  const std::string kind = json.value("event", "");
  if (const auto world = world_of_event(json)) take_world(*world);
  const auto robot = kind == "robot" ? robots_.find(json.value("name", "")) : robots_.end();
  if (robot != robots_.end()) {
    const auto place = [&](const char* name, mjData& data) {
      const std::vector<double> joints = numbers(json, name);
      if (joints.size() != robot->second.joints.count()) return;
      robot->second.joints.place(*model_, data, Eigen::Map<const JointVector>(joints.data(), std::ssize(joints)));
    };
    // the simulated world reports where its robots are, at its own tick
    if (!simulated_ || !robot->second.in_world) place("joints", *actual_);
    place("desired", *desired_);
  }
  if (kind != "world" && robot == robots_.end()) return;
  tick_ = std::max(tick_, json.value("tick", Tick{0}));
  changed_ = true;
}

void WorldView::take_world(const world::WorldSnapshot& world) {
  if (world.position_count != static_cast<std::uint32_t>(world_positions_) ||
      world.mocap_count != static_cast<std::uint32_t>(world_mocaps_))
    return;
  const double* const positions = world.values.data();
  const double* const mocap_positions = positions + world.position_count;
  const double* const mocap_quaternions = mocap_positions + static_cast<std::size_t>(3) * world.mocap_count;
  simulated_ = true;
  for (const Moved& joint : positions_) {
    std::copy_n(positions + joint.from, joint.count, actual_->qpos + joint.to);
    if (!joint.of_robot) std::copy_n(positions + joint.from, joint.count, desired_->qpos + joint.to);
  }
  for (const auto& [from, to] : mocaps_)
    for (mjData* data : {actual_.get(), desired_.get()}) {
      std::copy_n(mocap_positions + 3 * from, 3, data->mocap_pos + 3 * to);
      std::copy_n(mocap_quaternions + 4 * from, 4, data->mocap_quat + 4 * to);
    }
}

std::string WorldView::poses() {
  changed_ = false;
  Json json{{"event", "poses"}, {"tick", tick_}, {"bodies", Json::array()}, {"desired", Json::array()}};
  mj_kinematics(model_.get(), actual_.get());
  append_poses(*model_, *actual_, json["bodies"]);
  mj_kinematics(model_.get(), desired_.get());
  append_poses(*model_, *desired_, json["desired"]);
  return json.dump();
}

}  // namespace mrroc::cli
