#include "sim/world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "config/table.hpp"
#include "mrroc/errors.hpp"
#include "sim/contact_filter.hpp"

namespace mrroc::sim {

namespace {

[[noreturn]] void fail(std::string detail, Tick tick, std::string device = {}) {
  throw SystemError(ErrorCode::simulator, std::move(detail),
                    {.process = "sim", .device = std::move(device), .tick = tick});
}

}  // namespace

World::World(const Composition& composition, double period, double timestep)
    : model_(load_model(composition)),
      data_(nullptr),
      substeps_(static_cast<int>(std::lround(period / timestep))),
      weld_torques_(*model_),
      milling_(Milling::find(*model_, composition.scene)) {
  if (model_->opt.integrator != mjINT_EULER) {
    throw config::ConfigurationError(composition.scene, 0, "option.integrator",
                                     "is not Euler, in which the drives are integrated", "integrator=\"Euler\"");
  }
  model_->opt.timestep = timestep;
  mjcb_contactfilter = cannot_touch;
  data_ = make_data(*model_);
}

std::size_t World::attach(const std::string& robot, const std::vector<std::string>& joints, const JointVector& home) {
  robots_.emplace_back(*model_, robot, joints);
  terminals_.emplace_back(*model_, robot);
  robots_.back().place(*model_, *data_, home);
  return robots_.size() - 1;
}

std::size_t World::hold(const std::string& body, const std::string& key) {
  held_.emplace_back(*model_, body, key).hold(*model_, *data_);
  return held_.size() - 1;
}

void World::start() {
  const MujocoMessages messages;
  try {
    evaluate_motion();
    evaluate_forces();
    evaluate_motion();  // the forces' changes of M are undone
    check(-1, 0);
  } catch (const MujocoError& error) {
    fail(error.what(), 0);
  }
}

void World::drive(std::size_t index, const world::JointDrive& drive, Tick tick) {
  DrivenJoints& robot = robots_.at(index);
  if (drive.joint_count != robot.count()) {
    fail("a drive for " + std::to_string(drive.joint_count) + " joints, expected " + std::to_string(robot.count()),
         tick, robot.robot());
  }
  if (const int joint = robot.find_not_finite(drive); joint >= 0) {
    fail("the drive of joint " + std::to_string(joint + 1) + " is not finite", tick, robot.robot());
  }
  if (!robot.couples_one_chain(drive)) {
    fail("its drives couple joints on different branches of its MJCF", tick, robot.robot());
  }
  robot.drive(*model_, drive);
}

void World::brake(std::size_t index) {
  DrivenJoints& robot = robots_.at(index);
  if (robot.braked()) return;
  robot.brake(*model_, *data_);
  const MujocoMessages messages;
  mj_fwdVelocity(model_.get(), data_.get());  // its velocities have just become zero
}

void World::set_friction(std::size_t index, const std::array<double, kMaxJoints>& friction) noexcept {
  robots_.at(index).set_friction(*model_, friction);
}

void World::evaluate_motion() {
  mj_checkPos(model_.get(), data_.get());
  mj_checkVel(model_.get(), data_.get());
  mj_fwdPosition(model_.get(), data_.get());
  mj_sensorPos(model_.get(), data_.get());
  for (const DrivenJoints& robot : robots_) robot.add_travel(*data_);
  mj_fwdVelocity(model_.get(), data_.get());
  mj_sensorVel(model_.get(), data_.get());
}

void World::evaluate_forces() {
  for (const DrivenJoints& robot : robots_) robot.add_inertia(*data_);
  mj_factorM(model_.get(), data_.get());
  if (mj_isDual(model_.get())) mj_projectConstraint(model_.get(), data_.get());  // J M^-1 J^T of the changed M
  mj_passive(model_.get(), data_.get());                                         // the drives' damping may be new
  for (DrivenJoints& robot : robots_) robot.apply_torque(*model_, *data_, model_->opt.timestep);
  mj_fwdActuation(model_.get(), data_.get());
  mj_fwdAcceleration(model_.get(), data_.get());
  mj_fwdConstraint(model_.get(), data_.get());
  mj_sensorAcc(model_.get(), data_.get());
  weld_torques_.correct(*model_, *data_);
  mj_checkAcc(model_.get(), data_.get());
}

void World::step(Tick tick) {
  const MujocoMessages messages;
  try {
    for (int i = 0; i < substeps_; ++i) {
      const double time_before = data_->time;
      if (milling_) milling_->step(*model_, *data_, model_->opt.timestep);
      evaluate_forces();
      for (const DrivenJoints& robot : robots_) robot.add_damping(*data_, model_->opt.timestep);
      mj_Euler(model_.get(), data_.get());
      for (DrivenJoints& robot : robots_) robot.finish(*data_, model_->opt.timestep);
      evaluate_motion();
      check(time_before, tick);
    }
  } catch (const MujocoError& error) {
    fail(error.what(), tick);
  }
  for (const std::string& text : messages.warnings()) remember(text, tick);
}

void World::remember(const std::string& warning, Tick tick) {
  auto known = std::find_if(warnings_.begin(), warnings_.end(), [&](const auto& each) { return each.text == warning; });
  if (known == warnings_.end()) known = warnings_.insert(known, {warning, tick, 0});
  ++known->count;
}

void World::check(double time_before, Tick tick) const {
  const auto raised = [this](mjtWarning kind) { return data_->warning[kind].number > 0; };
  const auto info = [this](mjtWarning kind) { return data_->warning[kind].lastinfo; };
  if (raised(mjWARN_BADQPOS))
    fail("the position of " + name_of_position(*model_, info(mjWARN_BADQPOS)) + " diverged", tick);
  for (const auto& [kind, what] : {std::pair{mjWARN_BADQVEL, "velocity"}, std::pair{mjWARN_BADQACC, "acceleration"}}) {
    if (raised(kind)) fail(std::string("the ") + what + " of " + name_of_dof(*model_, info(kind)) + " diverged", tick);
  }
  if (raised(mjWARN_BADCTRL)) fail("control " + std::to_string(info(mjWARN_BADCTRL)) + " is not finite", tick);
  if (raised(mjWARN_INERTIA))
    fail("the inertia at " + name_of_dof(*model_, info(mjWARN_INERTIA)) + " is singular", tick);
  if (raised(mjWARN_CONTACTFULL)) fail("more contacts than the scene's <size nconmax> allows", tick);
  if (raised(mjWARN_CNSTRFULL)) fail("more constraints than the scene's <size njmax> allows", tick);
  if (!(data_->time > time_before)) fail("time did not advance: the world has reset itself", tick);
}

void World::put(std::size_t index, const Pose& pose) {
  held_.at(index).put(*model_, *data_, pose);
  const MujocoMessages messages;
  mj_fwdPosition(model_.get(), data_.get());
  mj_fwdVelocity(model_.get(), data_.get());
}

void World::set_outputs(std::size_t index, const ControllerIo& outputs) noexcept {
  terminals_.at(index).write(*model_, *data_, outputs);
}

void World::measure(std::size_t index, world::JointMeasurement& measurement) const noexcept {
  robots_.at(index).measure(*data_, measurement);
  measurement.inputs = terminals_.at(index).read(*data_);
}

}  // namespace mrroc::sim
