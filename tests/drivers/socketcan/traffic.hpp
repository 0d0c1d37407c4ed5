#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "can/fence.hpp"
#include "can_rig.hpp"

namespace mrroc::edp {

/// A robot with this many equal axes.
class ManyAxes final : public GearedModel {
 public:
  explicit ManyAxes(int count) {
    for (int i = 0; i < count; ++i) change().axes.push_back(test_axis(std::to_string(i + 1).c_str()));
    change().home = JointVector::Zero(count);
  }
  Pose flange(const JointVector&) const noexcept override { return Pose::Identity(); }
  ErrorCode inverse(const Pose&, const JointVector&, JointVector&) const noexcept override {
    return ErrorCode::out_of_workspace;
  }
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d&) const noexcept override {
    return Jacobian::Zero(6, joints.size());
  }
};

/// The frames of the driver with `axes` simulated drives in `mode`, which turn.
class Traffic {
 public:
  Traffic(int axes, canopen::DriveMode mode)
      : model_(axes),
        table_(table_of(model_.parameters(), mode)),
        rack_(table_, model_, bus_, true),
        hardware_(table_, model_.parameters(), kCanPeriod, bus_.opener(), {10, false, true}, true),
        shafts_(JointVector::Zero(axes)) {
    hardware_.open();
    ear_ = bus_.open();
    hardware_.enable(true);
    for (int i = 0; i < 1000 && hardware_.busy(); ++i) cycle();
    cycle();
  }

  /// One servo tick: its frames, in order, without heartbeats and fences.
  std::vector<can::Frame> cycle() {
    HardwareInput input;
    hardware_.read(tick_, input);
    if (tick_ == 1) shafts_ = input.motors;
    for (Eigen::Index i = 0; i < shafts_.size(); ++i) shafts_[i] += kStep * static_cast<double>(i + 1);
    hardware_.set_points(shafts_, JointVector::Constant(shafts_.size(), kStep / kCanPeriod));
    hardware_.write(tick_++, JointVector::Constant(shafts_.size(), 0.5));
    std::vector<can::Frame> frames;
    can::Frame frame;
    while (ear_->receive(frame, 0))
      if (frame.id < canopen::kSdoResponse) frames.push_back(frame);
    return frames;
  }
  const config::DriveTable& table() const { return table_; }

 private:
  static constexpr double kStep = 0.01;  // rad of a shaft in a tick

  /// With the default of a table of drives.
  static config::DriveTable table_of(const RobotParameters& robot, canopen::DriveMode mode) {
    config::DriveTable table = table_for(robot, mode);
    table.heartbeat = config::DriveTable{}.heartbeat;
    return table;
  }

  ManyAxes model_;
  config::DriveTable table_;
  TestBus bus_;
  Rack rack_;
  CanHardware hardware_;
  std::unique_ptr<can::Bus> ear_;
  JointVector shafts_;
  Tick tick_ = 1;
};

}  // namespace mrroc::edp
