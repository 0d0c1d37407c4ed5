#include "bench/kinematics/contest.hpp"

#include <time.h>

#include <stdexcept>
#include <utility>

#include "bench/kinematics/urdf_chain.hpp"
#include "config/robot_parameters_file.hpp"

namespace mrroc::bench {
namespace {

constexpr double kSame = 1e-9;      // m or rad, of closed forms and solved loops
constexpr double kPosition = 1e-5;  // m, of KDL's inverse
constexpr double kAngle = 1e-3;
constexpr int kPasses = 4;  // over the postures, of what takes a microsecond or less

double processor_ns() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

template <class Call>
double ns_per_call(std::size_t count, int passes, Call&& call) {
  const double begin = processor_ns();
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t i = 0; i < count; ++i) call(i);
  return (processor_ns() - begin) / (static_cast<double>(count) * passes);
}

double position_error(const Pose& a, const Pose& b) { return (a.translation() - b.translation()).norm(); }

double angle_error(const Pose& a, const Pose& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

}  // namespace

Contest::Contest(RobotModels models, const Options& options)
    : models_(std::move(models)), kinematics_(*models_.front()) {
  const UrdfChain urdf = urdf_chain(config::robot_file(robot(), robot() + ".urdf"), models_.front()->parameters());
  without_kdl_ = urdf.missing;
  if (without_kdl_.empty()) kdl_.emplace(urdf.chain);

  Postures postures(kinematics_, options.off, options.seed);
  for (int drawn = 0; std::ssize(postures_) < options.postures; ++drawn) {
    if (drawn > 2 * options.postures) throw std::runtime_error(robot() + ": most postures have no inverse");
    const Posture posture = postures.next();
    if (answer(posture)) postures_.push_back(posture);
  }
  for (std::size_t i = 0; i < postures_.size(); ++i) compare(i);
}

bool Contest::answer(const Posture& posture) {
  JointVector joints;
  if (kinematics_.inverse(posture.pose, posture.near, joints) != ErrorCode::none) {
    ++refused_.own;
    return false;
  }
  if (!kdl_) return true;
  kdl_->add(posture);
  const std::size_t last = postures_.size();
  if (!kdl_->lma(last)) {
    ++refused_.lma;
  } else if (!kdl_->newton(last)) {
    ++refused_.newton;
  } else {
    return true;
  }
  kdl_->remove_last();
  return false;
}

void Contest::compare(std::size_t i) {
  const auto demand = [&](bool agreed, const char* what) {
    if (!agreed) throw std::runtime_error(robot() + ": " + what + " at posture " + std::to_string(i));
  };
  const Posture& asked = postures_[i];
  JointVector joints;
  kinematics_.inverse(asked.pose, asked.near, joints);
  demand(kinematics_.direct(joints).isApprox(asked.pose, kSame), "the inverse does not give the pose back");
  if (!kdl_) return;
  kdl_->direct(i);
  demand(kdl_->pose().isApprox(asked.pose, kSame), "the pose is not KDL's");
  kdl_->jacobian(i);
  demand((kdl_->matrix() - kinematics_.jacobian(asked.joints)).cwiseAbs().maxCoeff() < kSame,
         "the Jacobian is not KDL's");
  const auto demand_reached = [&](const char* what) {
    const Pose reached = kinematics_.direct(kdl_->joints());
    demand(position_error(reached, asked.pose) < kPosition && angle_error(reached, asked.pose) < kAngle, what);
  };
  kdl_->lma(i);
  demand_reached("LMA does not give the pose back");
  kdl_->newton(i);
  demand_reached("KDL's Newton does not give the pose back");
}

void Contest::run_round(bool forwards) {
  const std::size_t count = postures_.size();
  Pose pose;
  JointVector joints;
  Jacobian matrix;
  const auto own = [&] {
    direct.own.push_back(
        ns_per_call(count, kPasses, [&](std::size_t i) { pose = kinematics_.direct(postures_[i].joints); }));
    inverse.own.push_back(ns_per_call(
        count, kPasses, [&](std::size_t i) { kinematics_.inverse(postures_[i].pose, postures_[i].near, joints); }));
    jacobian.own.push_back(
        ns_per_call(count, kPasses, [&](std::size_t i) { matrix = kinematics_.jacobian(postures_[i].joints); }));
  };
  const auto kdl = [&] {
    if (!kdl_) return;
    direct.kdl.push_back(ns_per_call(count, kPasses, [&](std::size_t i) { kdl_->direct(i); }));
    inverse.kdl.push_back(ns_per_call(count, 1, [&](std::size_t i) { kdl_->lma(i); }));
    newton.push_back(ns_per_call(count, 1, [&](std::size_t i) { kdl_->newton(i); }));
    jacobian.kdl.push_back(ns_per_call(count, kPasses, [&](std::size_t i) { kdl_->jacobian(i); }));
  };
  if (forwards) own();
  kdl();
  if (!forwards) own();
}

}  // namespace mrroc::bench
