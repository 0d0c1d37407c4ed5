#include "kinematics/measured_model.hpp"

#include <Eigen/SVD>
#include <optional>
#include <string>
#include <utility>

#include "kinematics/decorated_model.hpp"
#include "kinematics/measured_chain.hpp"
#include "kinematics/measured_joints.hpp"
#include "kinematics/newton.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::kinematics {

namespace {

constexpr double kReached = 1e-9;        // m and rad
constexpr int kFarIterations = 80;       // from a posture of another pose
constexpr int kRefinements = 20;         // from one of the type's own, which is near
constexpr double kSingularValue = 1e-6;  // smallest singular value of the Jacobian, m/rad and rad/rad

class EncodedModel : public DecoratedModel {
 public:
  EncodedModel(std::shared_ptr<const RobotModel> model, MeasuredJoints measured)
      : DecoratedModel(std::move(model)), measured_(std::move(measured)) {}
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override {
    const ErrorCode code = model().motors_to_joints(motors, joints);
    if (code == ErrorCode::none) joints = measured_.joints(joints);
    return code;
  }
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override {
    return model().joints_to_motors(measured_.encoders(joints), motors);
  }
  JointMatrix transmission(const JointVector& joints) const noexcept override {
    const JointVector encoders = measured_.encoders(joints);
    return model().transmission(encoders) * measured_.slopes(encoders).cwiseInverse().asDiagonal();
  }
  ClosedLoops closed_loops(const JointVector& joints) const override {
    return model().closed_loops(measured_.encoders(joints));
  }

 private:
  MeasuredJoints measured_;
};

/// The geometry of a measured chain.
class ChainedModel final : public EncodedModel {
 public:
  ChainedModel(std::shared_ptr<const RobotModel> model, MeasuredJoints measured, const SerialChain& chain)
      : EncodedModel(std::move(model), std::move(measured)), chain_(chain) {}

  Pose flange(const JointVector& joints) const noexcept override { return chain_.flange(joints); }
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept override {
    return chain_.jacobian(joints, offset);
  }
  ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept override {
    if (!flange.matrix().allFinite() || near.size() != chain_.size() || !near.allFinite())
      return ErrorCode::out_of_workspace;
    JointVector found = near;
    if (displacement(chain_.flange(near), flange).norm() < kReached) return judged(found, joints);
    const ErrorCode nominal = model().inverse(flange, near, found);
    const bool known = nominal == ErrorCode::none || nominal == ErrorCode::singular;
    if (known && improve(chain_, flange, kReached, kRefinements, found)) return judged(found, joints);
    found = near;
    if (improve(chain_, flange, kReached, kFarIterations, found)) return judged(found, joints);
    return ErrorCode::out_of_workspace;
  }
  void branches(const Pose& flange, const JointVector& near, BranchReceiver& receiver) const noexcept override {
    JointVector first = near;
    const ErrorCode code = inverse(flange, near, first);
    if (code == ErrorCode::none || code == ErrorCode::singular) receiver.add(first, true);
    Refining refining(chain_, flange, receiver);
    model().branches(flange, near, refining);
  }

 private:
  /// Improves the type's own postures of a pose.
  class Refining final : public BranchReceiver {
   public:
    Refining(const SerialChain& chain, const Pose& flange, BranchReceiver& receiver) noexcept
        : chain_(chain), flange_(flange), receiver_(receiver) {}
    void add(const JointVector& joints, bool /*exact*/) noexcept override {
      JointVector found = joints;
      if (improve(chain_, flange_, kReached, kRefinements, found)) receiver_.add(found, true);
    }
    bool found() noexcept override { return receiver_.found(); }

   private:
    const SerialChain& chain_;
    const Pose& flange_;
    BranchReceiver& receiver_;
  };

  ErrorCode judged(const JointVector& found, JointVector& joints) const noexcept {
    joints = found;
    const Eigen::JacobiSVD<Jacobian> svd(chain_.jacobian(joints, Eigen::Vector3d::Zero()));
    return svd.singularValues().minCoeff() < kSingularValue ? ErrorCode::singular : ErrorCode::none;
  }

  SerialChain chain_;
};

}  // namespace

RobotModels with_measured(RobotModels models, const MeasuredArm& measured) {
  if (models.empty() || !measured) return models;
  const int count = models.front()->joint_count();
  const MeasuredJoints joints(measured, count);
  if (!measured.links.empty() && count != 6)
    throw SystemError(ErrorCode::configuration, "measured links of a robot with " + std::to_string(count) +
                                                    " joints, expected a robot with 6, or no links");
  std::optional<SerialChain> chain;
  if (!measured.links.empty()) chain = measured_chain(*models.front(), measured.links);
  bool first = true;
  for (auto& model : models) {
    if (first && chain)
      model = std::make_shared<ChainedModel>(model, joints, *chain);
    else
      model = std::make_shared<EncodedModel>(model, joints);
    first = false;
  }
  return models;
}

}  // namespace mrroc::kinematics
