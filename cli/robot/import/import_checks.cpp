#include "cli/robot/import/import_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "kinematics/newton.hpp"

namespace mrroc::cli {

namespace {

using config::number_text;

constexpr std::uint64_t kCheckSeed = 2;
constexpr int kReachPostures = 2000, kModelPostures = 100, kTouchPostures = 100;
constexpr double kSameReach = 0.2;                // relative
constexpr double kExact = 1e-9, kSnapped = 1e-4;  // rad
constexpr double kSamePose = 1e-9;                // m, rad
constexpr double kAlways = 0.9;
constexpr double kAround = 0.6;  // rad; a tenth in m

}  // namespace

double reach_of(const UrdfArm& arm, const std::vector<AxisLimits>& axes) {
  std::mt19937_64 random(kCheckSeed);
  double reach = 0;
  for (int i = 0; i < kReachPostures; ++i)
    reach = std::max(reach, arm.chain.flange(random_posture(axes, random)).translation().norm());
  return reach;
}

double length_of(const UrdfArm& arm) {
  double length = arm.flange.translation().norm();
  for (std::size_t i = 1; i < arm.joints.size(); ++i) length += arm.joints[i].frame.translation().norm();
  return length;
}

void check_reach(const UrdfArm& arm, const edp::Urdf& urdf, double reach, const std::optional<double>& given) {
  if (!given || std::abs(reach - *given) <= kSameReach * *given) return;
  throw config::ConfigurationError(urdf.file(), arm.axes.front().line, "--reach " + number_text(*given),
                                   "the tip of this URDF reaches " + number_text(std::round(reach * 1000) / 1000) +
                                       " m, " + number_text(std::round(reach / *given * 100) / 100) + " times as far",
                                   "the same within 20 %: the scale of the URDF is wrong, or the tip is another link");
}

void note_nearly_parallel(const UrdfArm& arm, Findings& findings) {
  kinematics::SerialChain::Axes axes;
  arm.chain.compute(JointVector::Zero(arm.chain.size()), axes);
  for (std::size_t i = 1; i < arm.joints.size(); ++i) {
    const double cosine = axes.axis[i - 1].dot(axes.axis[i]), sine = axes.axis[i - 1].cross(axes.axis[i]).norm();
    for (const auto& [off, word] : {std::pair{sine, "parallel"}, {std::abs(cosine), "perpendicular"}}) {
      if (off <= kExact || off > kSnapped) continue;
      findings.warn("the axis is " + std::string(word) + " to the one before but for less than 1e-4 rad: the inverse " +
                        "takes it as " + word + ", then corrects the result",
                    "joint " + config::in_quotes(arm.axes[i].name), arm.axes[i].line);
    }
  }
}

void check_model(const UrdfArm& arm, const std::vector<AxisLimits>& axes, const std::filesystem::path& mjcf,
                 ArmWorld& world) {
  std::mt19937_64 random(kCheckSeed);
  for (int i = 0; i < kModelPostures; ++i) {
    const JointVector joints = random_posture(axes, random);
    const double error = kinematics::displacement(arm.chain.flange(joints), world.tool(joints)).norm();
    if (error <= kSamePose) continue;
    throw config::ConfigurationError(mjcf, 0, "site 'tool'",
                                     "is " + number_text(error) + " m or rad from the chain's flange",
                                     "at most " + number_text(kSamePose));
  }
}

std::set<BodyPair> always_touching(const std::vector<AxisLimits>& axes, ArmWorld& world) {
  std::mt19937_64 random(kCheckSeed);
  std::map<BodyPair, int> counts;
  for (int i = 0; i < kTouchPostures; ++i)
    for (const BodyPair& pair : world.contacts(random_posture(axes, random))) ++counts[pair];
  std::set<BodyPair> pairs;
  for (const auto& [pair, count] : counts)
    if (!pair.first.empty() && count >= kAlways * kTouchPostures) pairs.insert(pair);
  return pairs;
}

bool is_free_around(const JointVector& joints, const std::vector<AxisLimits>& axes, const std::set<BodyPair>& excluded,
                    ArmWorld& world) {
  const auto is_free = [&](const JointVector& posture) {
    const std::set<BodyPair> pairs = world.contacts(posture);
    return std::all_of(pairs.begin(), pairs.end(), [&](const BodyPair& pair) { return excluded.contains(pair); });
  };
  if (!is_free(joints)) return false;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    for (const double turn : {-kAround, kAround / 2, kAround}) {
      JointVector turned = joints;
      turned[index] = std::clamp(joints[index] + turn * (axes[i].slides ? 0.1 : 1), axes[i].position_min.value,
                                 axes[i].position_max.value);
      if (!is_free(turned)) return false;
    }
  }
  return true;
}

}  // namespace mrroc::cli
