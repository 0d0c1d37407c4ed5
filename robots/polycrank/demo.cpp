#include <mrroc/ecp.hpp>
#include <mrroc/robots/polycrank.hpp>
#include <numbers>

using namespace mrroc;

/// From rest: the tool stays at rest while the arm moves along its redundancy: crank 1 is commanded aside by `angle`
/// (rad) and back in `duration` (s), and the nearest joints that hold the tool are used.
class Swing : public Generator {
 public:
  Swing(Robot& robot, double angle, double duration)
      : Generator("Swing"), robot_(&robot), angle_(angle), duration_(duration) {}

  void start() override {
    joints_ = robot_->known_state().desired_joints;
    pose_ = robot_->known_state().desired_pose;
    time_ = 0;
  }
  bool terminal_condition() override { return time_ >= duration_; }
  void next_state() override {
    time_ += robot_->step_duration();
    RobotCommand& command = robot_->command();
    command.kind = CommandKind::joint;
    command.joints = joints(time_);
    if (time_ < duration_) command.joint_velocity = (joints(time_ + kMoment) - joints(time_ - kMoment)) / (2 * kMoment);
  }

 private:
  static constexpr double kMoment = 1e-3;  // s

  JointVector joints(double time) const {
    JointVector near = joints_, result = joints_;
    near[0] += angle_ * (1 - std::cos(2 * std::numbers::pi * std::min(time / duration_, 1.0))) / 2;
    robot_->kinematics().inverse(pose_, near, result);
    return result;
  }

  Robot* robot_;
  double angle_, duration_;
  double time_ = 0;
  JointVector joints_;
  Pose pose_ = Pose::Identity();
};

/// A tour: down to four posts, a swing of all cranks over the last one, then one whole turn of crank 1, which no joint
/// limit forbids, with the tool pointing up.
class Demo : public ecp::Task {
  Polycrank arm{*this};

  void run() override {
    for (const auto& [x, y] : {std::pair(0.74, -0.1), {0.94, -0.1}, {0.94, 0.1}, {0.74, 0.1}}) {
      Move({arm}, {}, JointLine{arm, Polycrank::tool_down(x, y, -0.35)});
      Move({arm}, {}, ToolVelocity{arm, {0, 0, 0.05}}.until(Travelled{arm, 0.08}));
      Move({arm}, {}, ToolVelocity{arm, {0, 0, -0.05}}.until(Travelled{arm, 0.08}));
    }
    Move({arm}, {}, Hold{arm, 0.5});
    Move({arm}, {}, Swing{arm, 0.8, 6.0});

    const JointVector home = arm.parameters().home;
    const JointVector up = home + std::numbers::pi * JointVector::Unit(7, 2);
    const JointVector turned = up + 2 * std::numbers::pi * (JointVector::Unit(7, 0) - JointVector::Unit(7, 2));
    Move({arm}, {}, JointLine{arm, up, 0.95});
    Move({arm}, {}, JointLine{arm, turned, 0.95});
    Move({arm}, {}, JointLine{arm, arm.kinematics().direct(home), 0.95});  // a revolution away from home
  }
};

MRROC_ECP(Demo)
