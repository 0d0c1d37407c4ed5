#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <limits>
#include <memory>
#include <random>
#include <string>

#include "config/entries/sensor_type.hpp"
#include "geometry/rigid_motion.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "sensors/camera/camera_sensor.hpp"
#include "sim/simulation.hpp"

namespace mrroc::vsp {

/// The rest of a test scene: no gravity, full light.
inline std::string scene_of(const std::string& world, const std::string& assets = "") {
  return "<mujoco>\n<compiler angle='radian'/>\n<option gravity='0 0 0'/>\n<asset>\n" + assets +
         "\n</asset>\n<worldbody>\n<light directional='true' pos='0 0 3' dir='0.2 0.1 -1'/>\n"
         "<geom name='table' type='box' size='1 1 0.05' pos='0 0 -0.05' rgba='0.55 0.57 0.6 1' contype='0' "
         "conaffinity='0'/>\n" +
         world + "\n</worldbody>\n</mujoco>\n";
}

/// A camera that looks down from 0.9 m, with the right of its picture towards x.
inline constexpr const char* kOverhead = "<camera name='eye' pos='0 0 0.9' fovy='45'/>";
/// A camera that looks at the origin from the side, 35 degrees off the vertical.
inline constexpr const char* kOblique =
    "<camera name='eye' pos='0 -0.5735764 0.8191520' euler='0.6108652 0 0' fovy='45'/>";
/// A flat red part, 60 x 40 x 4 mm, with its frame in the centre of its upper side.
inline constexpr const char* kPart =
    "<body name='part'><freejoint name='part'/><geom type='box' size='0.03 0.02 0.002' pos='0 0 -0.002' mass='0.1' "
    "rgba='0.8 0.1 0.1 1' contype='0' conaffinity='0'/></body>";
/// The same as a label, 0.2 mm thick: its sides are invisible.
inline constexpr const char* kLabel =
    "<body name='part'><freejoint name='part'/><geom type='box' size='0.03 0.02 0.0001' pos='0 0 -0.0001' mass='0.1' "
    "rgba='0.8 0.1 0.1 1' contype='0' conaffinity='0'/></body>";
/// The committed marker, number 7 of 4X4_50, with a black square 60 mm wide; its frame is the reported one.
inline constexpr const char* kMarker =
    "<body name='marker'><freejoint name='marker'/><geom type='box' size='0.04 0.04 0.001' pos='0 0 -0.001' mass='0.1' "
    "material='marker' contype='0' conaffinity='0'/></body>";
inline std::string marker_assets() {
  const std::string file = std::string(MRROC_SOURCE_DIR) + "/sensors/camera/marker_4x4_50_7.png";
  return "<texture name='marker' type='2d' file='" + file +
         "'/>\n<material name='marker' texture='marker' texuniform='false' specular='0' shininess='0'/>";
}

/// A camera and the world before it, without processes: the test stores the states in place of the simulator.
class SeenWorld {
 public:
  /// `robots`: type of each, named a, b, ... at the poses of `bases`.
  explicit SeenWorld(const std::string& scene, const std::string& keys, const std::string& robot = "",
                     std::vector<config::RobotEntry> robots = {}) {
    setenv("MRROC_SHARE", (std::string(MRROC_BINARY_DIR) + "/share/mrroc").c_str(), 1);
    deployment_.file = scratch_.path() / "test.toml";
    deployment_.robots = std::move(robots);
    if (!scene.empty()) {
      deployment_.sim.emplace();
      deployment_.sim->scene = scratch_.write("scene.xml", scene);
      model_ = sim::load_model(sim::compose(deployment_));
      positions_.assign(model_->qpos0, model_->qpos0 + model_->nq);
    }
    entry_.name = "eye";
    entry_.type = "camera";
    entry_.robot = robot;
    const config::Table table = config::Table::load(scratch_.write("keys.toml", keys));
    config::read_sensor_type(table, entry_);
    if (table.has("source")) entry_.source = table.text("source");
    table.finish();
    deployment_.sensors = {entry_};
  }

  /// The VSP's initialisation.
  void open() {
    sensor_.set_up(entry_, 0.002);
    source_ = sensor_.open_source({deployment_, entry_, 0, deployment_.sim ? memory_.get() : nullptr, 0.002});
  }
  const task_test::ScratchFolder& scratch() const { return scratch_; }
  config::Deployment& deployment() { return deployment_; }
  CameraSensor& sensor() { return sensor_; }
  Source& source() { return *source_; }

  void place(const std::string& joint, const Pose& pose) {
    double* at = position_of(joint);
    Eigen::Vector3d::Map(at) = pose.translation();
    const Eigen::Quaterniond q(pose.linear());
    at[3] = q.w(), at[4] = q.x(), at[5] = q.y(), at[6] = q.z();
  }
  void turn(const std::string& joint, double position) { *position_of(joint) = position; }

  void store(Tick tick) { memory_->snapshot.store(snapshot(tick)); }
  /// For cameras that are late.
  void store_seen(Tick tick) { memory_->seen.store(snapshot(tick)); }

  /// The reading of the world in its present state.
  SensorReading measure(Tick tick = 1) {
    store(tick);
    return read(tick);
  }
  SensorReading read(Tick tick) {
    RawReading raw;
    SensorReading v;
    state_ = source_->read(tick, raw);
    if (state_ != SourceState::ready) return v;
    v.tick = raw.tick;
    v.channel_count = static_cast<std::uint32_t>(sensor_.channels().size());  // as the Sampler hands it over
    v.values.fill(std::numeric_limits<double>::quiet_NaN());
    sensor_.aggregate(raw, v);
    return v;
  }
  SourceState state() const { return state_; }

 private:
  world::WorldSnapshot snapshot(Tick tick) const {
    world::WorldSnapshot snapshot{};
    snapshot.tick = tick;
    snapshot.position_count = static_cast<std::uint32_t>(positions_.size());
    std::copy(positions_.begin(), positions_.end(), snapshot.values.begin());
    return snapshot;
  }
  double* position_of(const std::string& joint) {
    const int id = mj_name2id(model_.get(), mjOBJ_JOINT, joint.c_str());
    EXPECT_GE(id, 0) << joint;
    return positions_.data() + model_->jnt_qposadr[std::max(id, 0)];
  }

  task_test::ScratchFolder scratch_;
  config::Deployment deployment_;
  config::SensorEntry entry_;
  sim::Model model_;
  std::vector<double> positions_;
  std::unique_ptr<world::WorldMemory> memory_ = std::make_unique<world::WorldMemory>();
  CameraSensor sensor_;
  std::unique_ptr<Source> source_;  // after the sensor: destroyed before it
  SourceState state_ = SourceState::not_ready;
};

/// The refusal of `start`; "" if there is none.
template <class Action>
std::string refusal(Action start) {
  try {
    start();
    return "";
  } catch (const Error& error) {
    return error.detail();
  } catch (const config::ConfigurationError& error) {
    return error.what();
  }
}

inline Eigen::Vector3d position_of(const SensorReading& v) { return {v.values[1], v.values[2], v.values[3]}; }
inline Eigen::Vector3d deviation_of(const SensorReading& v) { return {v.values[8], v.values[9], v.values[10]}; }
inline Eigen::Quaterniond orientation_of(const SensorReading& v) {
  return {v.values[4], v.values[5], v.values[6], v.values[7]};
}
inline bool detected(const SensorReading& v) {
  EXPECT_EQ(v.error.error_class, ErrorClass::none) << v.error.detail.view();
  return v.values[0] == 1;
}

/// Seeded numbers between two bounds.
class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double operator()(double from, double to) {
    return from + (to - from) * static_cast<double>(engine_()) / 0xffffffffU;
  }

 private:
  std::mt19937 engine_;  // its numbers are the standard's: the same everywhere
};

}  // namespace mrroc::vsp
