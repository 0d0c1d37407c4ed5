#include "edp/check/urdf_check.hpp"

#include <cmath>

#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "edp/check/postures.hpp"
#include "edp/check/urdf.hpp"

namespace mrroc::edp {
namespace {

using config::ConfigurationError;
using config::in_quotes;
using config::number_text;

constexpr std::uint64_t kUrdfSeed = 1;
constexpr int kUrdfPostures = 16;
constexpr double kApart = 1e-6;   // m, and rad
constexpr double kLimit = 1e-9;   // of a limit, relative where it is above 1
constexpr double kEndless = 1e6;  // m
constexpr const char* kFlange = "flange";
constexpr const char* kTool = "tool_frame";

/// rad
double angle_between(const Pose& a, const Pose& b) {
  const Eigen::Matrix3d r = a.linear().transpose() * b.linear();
  const Eigen::Vector3d twice_sine(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
  return std::atan2(twice_sine.norm(), r.trace() - 1);
}

std::string short_text(double value) {
  const std::string text = joints_text(Eigen::Matrix<double, 1, 1>(value));
  return text.substr(1, text.size() - 2);
}

class UrdfCheck {
 public:
  UrdfCheck(const RobotModel& model, const std::filesystem::path& file) : model_(model), urdf_(Urdf::load(file)) {
    if (!urdf_.has_link(kFlange) && !urdf_.has_link(kTool)) {
      throw ConfigurationError(file, 0, "", "no link to compare with the model", "a link 'flange' or 'tool_frame'");
    }
  }

  void check_axes() const {
    for (const AxisParameters& axis : model_.parameters().axes) {
      const Urdf::Joint* joint = urdf_.joint(axis.name);
      if (joint == nullptr) {
        throw ConfigurationError(urdf_.file(), 0, "", "no joint " + in_quotes(axis.name), "one for every axis");
      }
      if (joint->type == Urdf::Type::fixed) fail(*joint, "is fixed", "a joint that moves");
      check_velocity(*joint, axis.velocity_max);
      check_limit(*joint, "lower", joint->lower, axis.position_min);
      check_limit(*joint, "upper", joint->upper, axis.position_max);
    }
  }

  void check_posture(const JointVector& joints) const {
    Urdf::Positions positions;
    for (std::size_t i = 0; i < model_.parameters().axes.size(); ++i) {
      positions[model_.parameters().axes[i].name] = joints[static_cast<Eigen::Index>(i)];
    }
    const ClosedLoops loops = model_.closed_loops(joints);
    for (const auto& [name, position] : loops.joints) positions[name] = position;
    const Pose flange = model_.flange(joints);
    check_link(kFlange, flange, joints, positions);
    check_link(kTool, flange * model_.default_tool(), joints, positions);
    for (const auto& [one, other] : loops.joined) check_joined(one, other, joints, positions);
  }

 private:
  [[noreturn]] void fail(const Urdf::Joint& joint, const std::string& problem, const std::string& expected) const {
    throw ConfigurationError(urdf_.file(), joint.line, "joint " + in_quotes(joint.name), problem, expected);
  }

  void check_velocity(const Urdf::Joint& joint, double velocity) const {
    if (joint.velocity && std::abs(*joint.velocity - velocity) <= kLimit * std::max(1.0, velocity)) return;
    fail(joint, joint.velocity ? "velocity " + number_text(*joint.velocity) : "no velocity",
         "the axis's velocity_max " + number_text(velocity));
  }

  void check_limit(const Urdf::Joint& joint, const std::string& key, const std::optional<double>& found,
                   double limit) const {
    const std::string expected = "the axis's " + number_text(limit);
    if (joint.type == Urdf::Type::continuous) {
      if (std::isfinite(limit)) fail(joint, "is continuous, without " + key + " limit", expected);
      return;
    }
    const bool same =
        found && (std::isfinite(limit) ? std::abs(*found - limit) <= kLimit * std::max(1.0, std::abs(limit))
                                       : std::copysign(*found, limit) == *found && std::abs(*found) >= kEndless);
    if (!same) fail(joint, found ? key + " " + number_text(*found) : "no " + key + " limit", expected);
  }

  void check_link(const std::string& link, const Pose& expected, const JointVector& joints,
                  const Urdf::Positions& positions) const {
    if (!urdf_.has_link(link)) return;
    const Pose pose = urdf_.pose(link, positions);
    const double distance = (pose.translation() - expected.translation()).norm(), angle = angle_between(pose, expected);
    // written so that a value that is not a number fails
    if (distance <= kApart && angle <= kApart) return;
    throw ConfigurationError(urdf_.file(), urdf_.line_of_link(link), "link " + in_quotes(link),
                             "is at " + joints_text(pose.translation()) + " m, the model has it at " +
                                 joints_text(expected.translation()) + ", " + short_text(distance) + " m and " +
                                 short_text(angle) + " rad apart, at joints " + joints_text(joints),
                             at_most());
  }

  void check_joined(const std::string& one, const std::string& other, const JointVector& joints,
                    const Urdf::Positions& positions) const {
    for (const std::string& link : {one, other}) {
      if (!urdf_.has_link(link)) {
        throw ConfigurationError(urdf_.file(), 0, "", "no link " + in_quotes(link), "links that close the loops");
      }
    }
    const Eigen::Vector3d a = urdf_.pose(one, positions).translation(), b = urdf_.pose(other, positions).translation();
    if ((a - b).norm() <= kApart) return;
    throw ConfigurationError(urdf_.file(), urdf_.line_of_link(one), "link " + in_quotes(one),
                             "is at " + joints_text(a) + " m, link " + in_quotes(other) +
                                 ", to which it is joined, at " + joints_text(b) + ", " + short_text((a - b).norm()) +
                                 " m apart, at joints " + joints_text(joints),
                             at_most());
  }

  static std::string at_most() { return "at most " + number_text(kApart); }

  const RobotModel& model_;
  Urdf urdf_;
};

}  // namespace

void check_urdf(const RobotModel& model, const std::filesystem::path& file) {
  const UrdfCheck check(model, file);
  check.check_axes();
  for (const JointVector& joints : postures(model, kUrdfPostures, kUrdfSeed)) check.check_posture(joints);
}

}  // namespace mrroc::edp
