#pragma once

#include <functional>
#include <vector>

#include "drivers/loopback/loopback_hardware.hpp"
#include "edp/command/effector.hpp"
#include "edp/servo/servo.hpp"
#include "test_robots.hpp"

namespace mrroc::edp {

inline constexpr double kPeriod = 0.002;

/// Hardware under test, with faults to inject.
class FaultyHardware : public LoopbackHardware {
 public:
  using LoopbackHardware::LoopbackHardware;
  void enable(bool on) noexcept override {
    powered = on;
    LoopbackHardware::enable(on);
  }
  void read(Tick tick, HardwareInput& input) noexcept override {
    LoopbackHardware::read(tick, input);
    if (travel_.size() == 0)
      travel_ = JointVector::Zero(input.motors.size());
    else if (input.synchronised == was_synchronised_)  // else the counter has changed, in one tick of rest
      travel_ += input.motors - last_;
    last_ = input.motors;
    was_synchronised_ = input.synchronised;
    if (blind)
      for (AxisSwitches& switches : input.switches) switches.synchro = false;
    if (rewire) rewire(input);
    if (slip_.size() != 0) input.motors += slip_;
    if (jammed.size() == 0 && jam) jammed = input.motors;
    if (jammed.size() != 0 && !jam) {  // it continues from where it was stuck
      slip_ = (slip_.size() != 0 ? slip_ : JointVector::Zero(jammed.size()).eval()) + jammed - input.motors;
      input.motors = jammed;
      jammed.resize(0);
    }
    if (jam) input.motors = jammed.array() + (stuck || tick % 2 == 0 ? 0 : kTremble);
    if (spoil) spoil(input);
    if (positions_lost) input.synchronised = false;
    if (input.fault == ErrorCode::none) input.fault = fault;
  }
  void set_points(const JointVector&, const JointVector& velocity) noexcept override { velocity_target = velocity; }
  JointVector velocity_target;  ///< of the shafts, rad/s
  bool powered = false;
  bool jam = false;                         ///< the shafts oscillate at their positions
  bool stuck = false;                       ///< jammed, the shafts do not even oscillate: the reading of a dead encoder
  static constexpr double kTremble = 1e-4;  ///< rad
  bool blind = false;                       ///< the synchronisation switches are dead
  std::function<void(HardwareInput&)> rewire;  ///< replaces the driver's switches; may use `travelled`
  std::function<void(HardwareInput&)> spoil;   ///< changes the reported values, last of all
  /// Path of the shafts since the start, independent of their counters.
  const JointVector& travelled() const { return travel_; }
  bool positions_lost = false;
  ErrorCode fault = ErrorCode::none;
  JointVector jammed;

 private:
  JointVector last_, travel_, slip_;
  bool was_synchronised_ = false;
};

/// One robot in lockstep: the servo's tick, then the comms side, in the order of a participant of a deployment.
template <class Model>
struct Rig {
  explicit Rig(bool on = true, bool synchronised = true) : hardware(model, kPeriod, synchronised) {
    servo.use_emergency_stop(operators);
    effector.enable(on);
    tick();
  }

  /// Next servo tick; replies that left in it are appended to `replies`.
  void tick() {
    servo.tick(now);
    Reply reply;
    while (effector.poll(reply)) replies.push_back(reply);
    ++now;
  }
  void run(Tick ticks) {
    for (Tick i = 0; i < ticks; ++i) tick();
  }
  /// True: refused or answered at once; the answer is in `answer`.
  bool send(const RobotCommand& command) { return effector.accept(command, ++number, answer); }
  RobotState query() {
    send(RobotCommand{});
    return answer.state;
  }
  const Snapshot& seen() const { return servo.snapshot(); }

  Model model;
  FaultyHardware hardware;
  ServoChannel hand_over;
  ModelSet models{model};
  clock::EmergencyStop operators;
  Servo servo{models, hardware, kPeriod, hand_over};
  Effector effector{models, kPeriod, hand_over};
  Tick now = 0;  ///< the tick to be executed next
  std::uint64_t number = 0;
  Reply answer;
  std::vector<Reply> replies;
};

inline RobotCommand joint_command(const JointVector& joints, std::uint16_t steps, std::uint16_t reply_step) {
  RobotCommand command;
  command.kind = CommandKind::joint;
  command.joints = joints;
  command.motion_steps = steps;
  command.reply_step = reply_step;
  return command;
}

inline JointVector one(double value) { return JointVector::Constant(1, value); }

}  // namespace mrroc::edp
