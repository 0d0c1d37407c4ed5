#pragma once

#include <cstdint>
#include <memory>

#include "driver_faults/device.hpp"
#include "edp/command/effector.hpp"
#include "edp/servo/servo.hpp"

namespace mrroc::driver_faults {

/// The worst that a cell's arm has done, as parts of its limits.
struct Worst {
  double set_speed = 0;         ///< of the set-points
  double set_acceleration = 0;  ///< of the set-points
  double speed = 0;             ///< of the arm
};

/// An EDP's servo with a device.
class Cell {
 public:
  explicit Cell(std::unique_ptr<Device> device);

  void tick();
  void ticks(int count);
  /// Ticks until the arm has stood for 50 ticks, at most 5000. False: it does not stand.
  bool settle();
  /// Switches the drives on, or clears a fault first; false: not within 5000 ticks.
  bool recover();
  /// Starts a motion of all axes, of 400 ticks.
  void start_move(double way);
  bool answered() const { return reply_.command == number_; }
  /// Of the last motion, once it is answered.
  ErrorCode answer() const { return reply_.state.error.code; }
  ErrorCode fault() const { return servo_.snapshot().fault.code; }
  Tick now() const { return now_; }
  /// The last tick in which the arm moved.
  Tick moved() const { return moved_; }

  Device& device() { return *device_; }

  Worst worst;

 private:
  void judge(double elapsed);
  void send(const RobotCommand& command);

  std::unique_ptr<Device> device_;
  edp::ServoChannel channel_;
  edp::ModelSet models_;
  edp::Servo servo_;
  edp::Effector effector_;
  edp::Reply reply_;
  std::uint64_t number_ = 0;
  Tick now_ = 0, moved_ = 0;
  double then_ = 0, elapsed_ = 1;
  JointVector position_, velocity_;
  int continuous_ = 0;  ///< ticks in which the set-points were those of one plan
};

}  // namespace mrroc::driver_faults
