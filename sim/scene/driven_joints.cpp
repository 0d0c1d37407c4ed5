#include "sim/scene/driven_joints.hpp"

#include <algorithm>
#include <cmath>

#include "config/table.hpp"

namespace mrroc::sim {

namespace {

constexpr double kBrakeInertia = 1e10;  // kg m^2 or kg: the largest force moves the joint less than rounding does

[[noreturn]] void refuse(const std::string& robot, const std::string& problem, const std::string& expected) {
  throw config::ConfigurationError({}, 0, "robots." + robot, problem, expected);
}

std::string joints_of(const mjModel& model, const std::string& robot) {
  std::string list;
  for (int i = 0; i < model.njnt; ++i) {
    const std::string name = model.names + model.name_jntadr[i];
    if (name.starts_with(robot + "/")) list += (list.empty() ? "" : ", ") + name.substr(robot.size() + 1);
  }
  return list.empty() ? "none" : list;
}

/// Whether the robot's tuple "endless" lists the joint.
bool is_endless(const mjModel& model, const std::string& robot, int joint) {
  const int tuple = mj_name2id(&model, mjOBJ_TUPLE, (robot + "/endless").c_str());
  if (tuple < 0) return false;
  for (int i = model.tuple_adr[tuple]; i < model.tuple_adr[tuple] + model.tuple_size[tuple]; ++i) {
    if (model.tuple_objtype[i] == mjOBJ_JOINT && model.tuple_objid[i] == joint) return true;
  }
  return false;
}

/// Solves the joint equalities y - y0 = polynomial(x - x0) in which x is the joint at `leader` of qpos.
void place_followers(const mjModel& model, mjData& data, int leader) {
  for (int i = 0; i < model.neq; ++i) {
    if (model.eq_type[i] != mjEQ_JOINT || model.eq_obj2id[i] < 0) continue;
    if (model.jnt_qposadr[model.eq_obj2id[i]] != leader) continue;
    const int follower = model.jnt_qposadr[model.eq_obj1id[i]];
    const mjtNum* a = model.eq_data + mjNEQDATA * i;
    const double x = data.qpos[leader] - model.qpos0[leader];
    data.qpos[follower] = model.qpos0[follower] + a[0] + x * (a[1] + x * (a[2] + x * (a[3] + x * a[4])));
  }
}

}  // namespace

DrivenJoints::DrivenJoints(mjModel& model, const std::string& robot, const std::vector<std::string>& names)
    : robot_(robot), count_(names.size()), servo_(model) {
  if (names.size() > kMaxJoints) {
    refuse(robot, std::to_string(names.size()) + " joints", "at most " + std::to_string(kMaxJoints));
  }
  for (std::size_t i = 0; i < count_; ++i) {
    const int joint = mj_name2id(&model, mjOBJ_JOINT, (robot + "/" + names[i]).c_str());
    if (joint < 0) refuse(robot, "no joint \"" + names[i] + "\" in its MJCF", "one of " + joints_of(model, robot));
    if (model.jnt_type[joint] != mjJNT_HINGE && model.jnt_type[joint] != mjJNT_SLIDE) {
      refuse(robot, "joint \"" + names[i] + "\" is neither", "a hinge or a slide");
    }
    joints_[i].endless = is_endless(model, robot, joint);
    places_[i] = {.dof = model.jnt_dofadr[joint], .position = model.jnt_qposadr[joint]};
    model.dof_armature[places_[i].dof] = 0;
    model.dof_damping[places_[i].dof] = 0;
    // "simple" dofs are factored as if M were diagonal, which B need not be
    model.dof_simplenum[places_[i].dof] = 0;
    model.body_simple[model.jnt_bodyid[joint]] = 0;
  }
  disable_actuators(model);
  find_addresses(model);
  find_travel_sensors(model);
}

void DrivenJoints::disable_actuators(mjModel& model) const {
  for (int a = 0; a < model.nu; ++a) {
    if (model.actuator_trntype[a] != mjTRN_JOINT && model.actuator_trntype[a] != mjTRN_JOINTINPARENT) continue;
    const int dof = model.jnt_dofadr[model.actuator_trnid[2 * a]];
    const auto end = places_.begin() + static_cast<std::ptrdiff_t>(count_);
    if (std::none_of(places_.begin(), end, [dof](const JointServo::Joint& joint) { return joint.dof == dof; }))
      continue;
    mju_zero(model.actuator_gainprm + mjNGAIN * a, mjNGAIN);
    mju_zero(model.actuator_biasprm + mjNBIAS * a, mjNBIAS);
  }
}

void DrivenJoints::find_addresses(const mjModel& model) {
  addresses_.fill(-1);
  for (std::size_t i = 0; i < count_; ++i) {
    for (std::size_t j = 0; j < count_; ++j) {
      // row `dof` of M holds the entries of dof, its parent, its grandparent, ...
      int address = model.dof_Madr[places_[i].dof];
      for (int dof = places_[i].dof; dof >= 0; dof = model.dof_parentid[dof], ++address) {
        if (dof != places_[j].dof) continue;
        addresses_[i * kMaxJoints + j] = addresses_[j * kMaxJoints + i] = address;
      }
    }
  }
}

void DrivenJoints::find_travel_sensors(const mjModel& model) {
  for (int sensor = 0; sensor < model.nsensor; ++sensor) {
    if (model.sensor_type[sensor] != mjSENS_JOINTPOS) continue;
    for (std::size_t i = 0; i < count_; ++i) {
      const bool its_own = model.jnt_dofadr[model.sensor_objid[sensor]] == places_[i].dof;
      if (joints_[i].endless && its_own) travel_sensors_.push_back({model.sensor_adr[sensor], i});
    }
  }
}

void DrivenJoints::place(const mjModel& model, mjData& data, const JointVector& position) noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    Joint& joint = joints_[i];
    const double value = position[static_cast<Eigen::Index>(i)];
    joint.travel = joint.endless ? value : 0;
    joint.held = joint.endless ? 0 : value;
    data.qpos[places_[i].position] = joint.held;
    data.qvel[places_[i].dof] = 0;
    place_followers(model, data, places_[i].position);
  }
  braked_ = true;
}

int DrivenJoints::find_not_finite(const world::JointDrive& drive) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    double sum = drive.torque[i] + drive.bias[i] + drive.position[i] + drive.velocity[i] + drive.bandwidth;
    for (std::size_t j = 0; j < count_; ++j) sum += entry(drive.rotor_inertia, i, j) + entry(drive.damping, i, j);
    if (!std::isfinite(sum)) return static_cast<int>(i);
  }
  return -1;
}

bool DrivenJoints::couples_one_chain(const world::JointDrive& drive) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    for (std::size_t j = 0; j < count_; ++j) {
      const bool coupled = entry(drive.rotor_inertia, i, j) != 0 || entry(drive.damping, i, j) != 0;
      if (coupled && addresses_[i * kMaxJoints + j] < 0) return false;
    }
  }
  return true;
}

void DrivenJoints::drive(mjModel& model, const world::JointDrive& drive) noexcept {
  drive_ = drive;
  braked_ = false;
  elapsed_ = 0;
  for (std::size_t i = 0; i < count_; ++i) drive_.position[i] -= joints_[i].travel;
  for (std::size_t i = 0; i < count_; ++i) model.dof_damping[places_[i].dof] = entry(drive.damping, i, i);
}

void DrivenJoints::set_friction(mjModel& model, const std::array<double, kMaxJoints>& friction) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) model.dof_frictionloss[places_[i].dof] = friction[i];
}

void DrivenJoints::brake(mjModel& model, mjData& data) noexcept {
  if (braked_) return;
  braked_ = true;
  drive_ = {};
  torque_.fill(0);
  for (std::size_t i = 0; i < count_; ++i) {
    joints_[i].held = data.qpos[places_[i].position];
    data.qvel[places_[i].dof] = 0;
    model.dof_damping[places_[i].dof] = 0;
    model.dof_frictionloss[places_[i].dof] = 0;
  }
}

void DrivenJoints::add_inertia(mjData& data) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    if (braked_) data.qM[addresses_[i * kMaxJoints + i]] += kBrakeInertia;
    for (std::size_t j = 0; !braked_ && j <= i; ++j) {
      const int address = addresses_[i * kMaxJoints + j];
      if (address >= 0) data.qM[address] += entry(drive_.rotor_inertia, i, j);
    }
  }
}

void DrivenJoints::apply_torque(const mjModel& model, mjData& data, double h) noexcept {
  if (drive_.kind != world::JointDrive::Kind::torque) {
    servo_.compute(model, data, drive_, places_.data(), count_, elapsed_, h, torque_);
    for (std::size_t i = 0; i < count_; ++i) data.qfrc_applied[places_[i].dof] = torque_[i];
    return;
  }
  for (std::size_t i = 0; i < count_; ++i) {
    double torque = drive_.torque[i] - drive_.bias[i];
    for (std::size_t j = 0; j < count_; ++j) {
      if (j != i) torque -= entry(drive_.damping, i, j) * data.qvel[places_[j].dof];
    }
    data.qfrc_applied[places_[i].dof] = torque;
  }
}

void DrivenJoints::add_damping(mjData& data, double h) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const int address = addresses_[i * kMaxJoints + j];
      if (address >= 0) data.qM[address] += h * entry(drive_.damping, i, j);
    }
  }
}

void DrivenJoints::finish(mjData& data, double h) noexcept {
  elapsed_ += h;
  for (std::size_t i = 0; i < count_; ++i) {
    Joint& joint = joints_[i];
    if (braked_) {
      data.qpos[places_[i].position] = joint.held;
      data.qvel[places_[i].dof] = 0;
    } else if (joint.endless) {
      joint.travel += data.qpos[places_[i].position];
      drive_.position[i] -= data.qpos[places_[i].position];
      data.qpos[places_[i].position] = 0;
    }
  }
}

void DrivenJoints::add_travel(mjData& data) const noexcept {
  for (const TravelSensor& sensor : travel_sensors_) data.sensordata[sensor.address] += joints_[sensor.joint].travel;
}

void DrivenJoints::measure(const mjData& data, world::JointMeasurement& measurement) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    measurement.position[i] = joints_[i].travel + data.qpos[places_[i].position];
    measurement.velocity[i] = data.qvel[places_[i].dof];
    measurement.torque[i] = torque_[i];
  }
}

}  // namespace mrroc::sim
