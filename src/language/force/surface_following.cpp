#include "mrroc/generators/surface_following.hpp"

#include <algorithm>
#include <cmath>

#include "core/require.hpp"
#include "language/force/force_step.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kFelt = 0.1;        // of the force: less is not contact
constexpr int kPatience = 10;        // steps without contact
constexpr double kPathGain = 4;      // 1/s, back to the path
constexpr double kMovesAlong = 0.3;  // of the commanded path: less does not determine the slope

}  // namespace

SurfaceFollowing::SurfaceFollowing(Robot& robot, double force, double speed, const SurfaceContact& contact)
    : Generator("SurfaceFollowing"), robot_(&robot), force_(force), speed_(speed), contact_(contact) {
  require_above_zero("SurfaceFollowing", "force", force);
  require_above_zero("SurfaceFollowing", "admittance", contact.admittance);
  require_not_negative("SurfaceFollowing", "inertia", contact.inertia);
  require_above_zero("SurfaceFollowing", "approach speed", contact.approach_speed);
  require_above_zero("SurfaceFollowing", "acceleration", contact.acceleration);
  require_not_negative("SurfaceFollowing", "turning gain", contact.turning_gain);
  require_above_zero("SurfaceFollowing", "angular speed", contact.angular_speed);
  require_above_zero("SurfaceFollowing", "angular acceleration", contact.angular_acceleration);
  check_load("SurfaceFollowing", contact.load, contact.gravity);
}

SurfaceFollowing::SurfaceFollowing(Robot& robot, double force, const Eigen::Vector3d& velocity,
                                   const SurfaceContact& contact)
    : SurfaceFollowing(robot, force, velocity.norm(), contact) {
  require(velocity.allFinite() && velocity.z() == 0, "SurfaceFollowing", "velocity along the tool's z", velocity.z(),
          "0, the force is there");
  velocity_ = velocity;
}

SurfaceFollowing::SurfaceFollowing(Robot& robot, double force, std::vector<Eigen::Vector3d> path, double speed,
                                   const SurfaceContact& contact)
    : SurfaceFollowing(robot, force, speed, contact) {
  require_above_zero("SurfaceFollowing", "speed", speed);
  require(path.size() >= 2, "SurfaceFollowing", "points of the path", static_cast<double>(path.size()), "at least 2");
  ways_.push_back(0);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double leg = (path[i] - path[i - 1]).norm();
    require_above_zero("SurfaceFollowing", "way to the next point of the path", leg);
    ways_.push_back(ways_.back() + leg);
  }
  path_ = std::move(path);
}

void SurfaceFollowing::start() {
  way_ = 0;
  resume();
}

void SurfaceFollowing::resume() {
  way_speed_ = 0;
  touching_ = false;
  lost_ = 0;
  commanded_.setZero();
  displacement_.setZero();
  turned_.setZero();
  before_ = robot_->known_state().pose.translation();
}

bool SurfaceFollowing::terminal_condition() {
  if (path_.empty() || way_ < length()) return false;
  const Pose& tool = robot_->state().pose;
  Eigen::Vector3d left = tool.linear().transpose() * (path_.back() - tool.translation());
  left.z() = 0;
  return left.norm() <= kTolerance;
}

void SurfaceFollowing::next_state() {
  const RobotState& state = robot_->state();
  const Wrench weight = weight_of(contact_.load, state.pose.linear(), contact_.gravity);
  const Wrench felt = state.wrench - weight;
  const double step = robot_->step_duration();
  const Eigen::Vector3d gone = state.pose.linear().transpose() * (state.pose.translation() - before_);
  displacement_ += step / (kSmoothing + step) * (gone - displacement_);
  before_ = state.pose.translation();
  update_contact(-felt[2]);

  Eigen::Vector3d wanted = Eigen::Vector3d::Zero();
  if (touching_) wanted = path_.empty() ? robot_->task().operator_speed() * velocity_ : along_path();
  commanded_ = stepped(commanded_, wanted, contact_.acceleration * step);
  const bool turns = contact_.turn_to_normal && touching_;
  const Eigen::Vector3d turn = turns ? turning(felt) : Eigen::Vector3d::Zero();
  turned_ = stepped(turned_, turn, contact_.angular_acceleration * step);

  RobotCommand& command = robot_->command();
  command.kind = CommandKind::force;
  command.twist.head<3>() = commanded_;
  command.twist.tail<3>() = turned_;
  const double pressing = touching_ ? force_ : approach_force();
  command.force.contact(2, weight[2] - pressing);
  command.force.admittance[2] = contact_.admittance;
  command.force.inertia[2] = contact_.inertia;
}

void SurfaceFollowing::update_contact(double pressed) {
  if (touching_) {
    lost_ = pressed < kFelt * force_ ? lost_ + 1 : 0;
    touching_ = lost_ <= kPatience;
  } else if (pressed >= 0.5 * approach_force()) {
    touching_ = true;
    lost_ = 0;
  }
}

double SurfaceFollowing::approach_force() const {
  return std::min(force_, contact_.approach_speed / contact_.admittance);
}

Eigen::Vector3d SurfaceFollowing::along_path() {
  const double step = robot_->step_duration(), speed = robot_->task().operator_speed() * speed_;
  const double allowed = approach_speed(length() - way_, speed, contact_.acceleration, kPathGain);
  way_speed_ = std::min(allowed, way_speed_ + contact_.acceleration * step);
  way_ += way_speed_ * step;
  if (length() - way_ < 0.2 * kTolerance) way_ = length();
  const Pose& tool = robot_->state().pose;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  const Eigen::Vector3d error = point_at(way_, direction) - tool.translation();
  // no faster back to the path than along it
  const Eigen::Vector3d correction = stepped(Eigen::Vector3d::Zero(), kPathGain * error, speed);
  Eigen::Vector3d velocity = tool.linear().transpose() * (way_speed_ * direction + correction);
  velocity.z() = 0;
  return velocity;
}

Eigen::Vector3d SurfaceFollowing::point_at(double way, Eigen::Vector3d& direction) const {
  const auto after = std::upper_bound(ways_.begin() + 1, ways_.end() - 1, way);
  const auto i = static_cast<std::size_t>(after - ways_.begin());
  direction = (path_[i] - path_[i - 1]) / (ways_[i] - ways_[i - 1]);
  return path_[i - 1] + direction * (way - ways_[i - 1]);
}

Eigen::Vector3d SurfaceFollowing::turning(const Wrench& felt) const {
  const double speed = commanded_.norm(), pressed = -felt[2];
  if (!(speed > 0) || pressed < kFelt * force_) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d along = commanded_ / speed, across = along.cross(Eigen::Vector3d::UnitZ());
  const double gone = displacement_.dot(along);
  if (gone < kMovesAlong * speed * robot_->step_duration()) return Eigen::Vector3d::Zero();
  // the angle about `across` that aligns x with the path, and that about `along` that aligns z with the force
  const double climb = std::atan2(displacement_.z(), gone);
  const double lean = std::atan2(-felt.head<3>().dot(across), pressed);
  return stepped(Eigen::Vector3d::Zero(), contact_.turning_gain * (climb * across + lean * along),
                 contact_.angular_speed);
}

}  // namespace mrroc
