// Commands of any content that the link's decoder accepts, to an EDP at any time, with its drives switched on and off.
#include <cmath>
#include <set>

#include "edp/rig.hpp"
#include "fuzz/fuzz.hpp"

namespace {

using namespace mrroc;
using namespace mrroc::edp;

constexpr Tick kLongest = 4000;
constexpr double kRounding = 1e-6;  // relative
constexpr double kBeyond = 1e-3;    // rad or m that drives overshoot while they are switched off

/// One robot under test, checked in every tick.
class Driver {
 public:
  Driver() {
    // its drives are models that lag; this fuzzer does not check the lag
    for (AxisParameters& axis : rig_.model.change().axes) axis.following_error_max = 1e9;
    previous_ = rig_.seen().desired;
  }

  void run(fuzz::Bytes& input) {
    while (!input.empty() && rig_.now < kLongest) {
      const auto event = input.take<std::uint8_t>();
      if (event == 0xff) {
        on_ = !on_;
        rig_.effector.enable(on_);
      } else if (event >= 0x80) {
        send(command_from(input));
      }
      for (int i = event % 64; i >= 0; --i) tick();
    }
    while (!expected_.empty() && rig_.now < 40 * kLongest) tick();
    fuzz::require(expected_.empty(), "every command gets a reply");
  }

 private:
  /// Small numbers, numbers of the input, or any bits.
  double number(fuzz::Bytes& input, bool any) {
    return any ? input.take<double>() : input.take<std::int16_t>() / 8192.0;
  }

  JointVector vector(fuzz::Bytes& input, bool any) {
    JointVector values(any ? input.take<std::uint8_t>() % (kMaxJoints + 1) : 4);
    for (double& value : values) value = number(input, any);
    return values;
  }

  Pose pose(fuzz::Bytes& input, bool any) {
    Pose pose = Pose::Identity();
    if (any) {
      for (int i = 0; i < 12; ++i) pose.affine()(i / 4, i % 4) = input.take<double>();
      return pose;
    }
    for (int i = 0; i < 3; ++i) pose.translation()[i] = number(input, false);
    pose.rotate(Eigen::AngleAxisd(number(input, false), Eigen::Vector3d::UnitZ()));
    return pose;
  }

  RobotCommand command_from(fuzz::Bytes& input) {
    RobotCommand command;
    command.kind = static_cast<CommandKind>(input.take<std::uint8_t>() % 15);
    const auto flags = input.take<std::uint8_t>();
    const bool any = (flags & 1) != 0;
    command.relative = (flags & 2) != 0;
    command.interpolation = static_cast<Interpolation>(flags / 4 % 3);
    command.motion_steps = any ? input.take<std::uint16_t>() : input.take<std::uint8_t>();
    command.reply_step = any ? input.take<std::uint16_t>() : std::max<std::uint16_t>(1, command.motion_steps);
    if ((flags & 0x10) != 0) command.start_tick = any ? input.take<Tick>() : rig_.now + input.take<std::uint8_t>();
    command.joints = vector(input, any);
    if ((flags & 0x20) != 0) command.joint_velocity = vector(input, any);
    if ((flags & 0x40) != 0) command.joint_acceleration = vector(input, any);
    command.pose = pose(input, any);
    for (double& value : command.twist) value = number(input, any);
    if (any) command.twist_acceleration = vector(input, any);
    for (AxisBehaviour& behaviour : command.force.behaviour)
      behaviour = static_cast<AxisBehaviour>(input.take<std::uint8_t>() % 3);
    for (int i = 0; i < 6; ++i) {
      command.force.wrench[i] = number(input, any);
      command.force.inertia[i] = number(input, any);
      command.force.admittance[i] = number(input, any);
    }
    command.stop.ticks = any ? input.take<std::uint16_t>() : input.take<std::uint8_t>();
    command.stop.rate = number(input, any);
    command.stop.group = input.take<std::uint8_t>() % 3;
    command.choice = input.take<std::uint8_t>();
    command.with_outputs = (flags & 0x80) != 0;
    command.outputs.digital = input.take<std::uint16_t>();
    for (double& value : command.outputs.analog) value = number(input, any);
    return command;
  }

  void send(const RobotCommand& command) {
    if (!rig_.send(command)) {
      expected_.insert(rig_.number);
      return;
    }
    fuzz::require(rig_.answer.command == rig_.number, "an answer belongs to the command");
    check(rig_.answer.state);
  }

  void tick() {
    rig_.tick();
    check_set_point();
    for (const Reply& reply : rig_.replies) {
      fuzz::require(expected_.erase(reply.command) == 1, "a command gets one reply");
      check(reply.state);
    }
    rig_.replies.clear();
  }

  void check(const RobotState& state) const {
    fuzz::require(state.error.error_class == ErrorClass::none || !state.error.detail.empty(), "an error has a text");
    fuzz::require(state.joints.allFinite() && state.pose.matrix().allFinite() && state.desired_joints.allFinite() &&
                      state.desired_velocity.allFinite() && state.desired_pose.matrix().allFinite(),
                  "a state is finite");
  }

  void check_set_point() {
    const DesiredState& now = rig_.seen().desired;
    const bool was_powered = powered_;
    powered_ = rig_.hardware.powered;
    fuzz::require(now.position.allFinite() && now.velocity.allFinite(), "a set-point is finite");
    if (powered_ && was_powered) {  // else it follows the measured position
      for (Eigen::Index i = 0; i < now.position.size(); ++i) {
        const AxisParameters& axis = rig_.model.parameters().axes[static_cast<std::size_t>(i)];
        fuzz::require(now.position[i] >= axis.position_min - kBeyond && now.position[i] <= axis.position_max + kBeyond,
                      "a set-point is within the position limits");
        fuzz::require(std::abs(now.velocity[i]) <= axis.velocity_max * (1 + kRounding), "no set-point is too fast");
        fuzz::require(
            std::abs(now.position[i] - previous_.position[i]) <= axis.velocity_max * kPeriod * (1 + kRounding),
            "no set-point jumps");
        fuzz::require(std::abs(now.velocity[i] - previous_.velocity[i]) <=
                          axis.acceleration_max * kPeriod * (1 + kRounding) + kRounding,
                      "the velocity is continuous");
      }
    }
    previous_ = now;
  }

  Rig<Gantry> rig_;
  DesiredState previous_;
  bool on_ = true;
  bool powered_ = false;
  std::set<std::uint64_t> expected_;
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes input(data, size);
  Driver().run(input);
  return 0;
}
