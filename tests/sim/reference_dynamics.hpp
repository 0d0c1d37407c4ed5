#pragma once

#include <Eigen/Dense>

#include "sim/scene/model.hpp"
#include "world/world_memory.hpp"

namespace mrroc::sim {

/// The same physics in the direct form, with dense matrices and without constraints, for all dofs of a world at once:
///   v' = v + h (M + B + h D)^-1 (tau - c - D v - C(q, v)),   q' = q + h v'
/// with M and C from MuJoCo's mj_fullM and mj_rne on a separate model.
class ReferenceDynamics {
 public:
  ReferenceDynamics(Model model, double timestep) : model_(std::move(model)), data_(make_data(*model_)), h_(timestep) {
    for (int i = 0; i < model_->nv; ++i) model_->dof_armature[i] = model_->dof_damping[i] = 0;
    model_->opt.timestep = timestep;
  }

  mjData& data() { return *data_; }

  void step(const Eigen::MatrixXd& b, const Eigen::MatrixXd& d, const Eigen::VectorXd& tau, const Eigen::VectorXd& c) {
    const int n = model_->nv;
    mj_fwdPosition(model_.get(), data_.get());
    mj_fwdVelocity(model_.get(), data_.get());
    Eigen::VectorXd coriolis_and_gravity(n);
    mj_rne(model_.get(), data_.get(), 0, coriolis_and_gravity.data());
    Eigen::Map<Eigen::VectorXd> v(data_->qvel, n), q(data_->qpos, n);
    v += h_ * (mass() + b + h_ * d).ldlt().solve(tau - c - d * v - coriolis_and_gravity);
    q += h_ * v;
  }

  /// Kinetic and potential energy with rotor inertia `b`, of the present q and v.
  double energy(const Eigen::MatrixXd& b) {
    mj_fwdPosition(model_.get(), data_.get());
    const Eigen::Map<Eigen::VectorXd> v(data_->qvel, model_->nv);
    double potential = 0;
    for (int i = 0; i < model_->nbody; ++i) {
      potential -= model_->body_mass[i] * mju_dot3(model_->opt.gravity, data_->xipos + 3 * i);
    }
    return potential + 0.5 * v.dot((mass() + b) * v);
  }

 private:
  Eigen::MatrixXd mass() const {
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> m(model_->nv, model_->nv);
    mj_fullM(model_.get(), m.data(), data_->qM);
    return m;
  }

  Model model_;
  Data data_;
  double h_;
};

/// A drive with these matrices, enabled.
inline world::JointDrive drive_of(const Eigen::MatrixXd& b, const Eigen::MatrixXd& d, const Eigen::VectorXd& tau,
                                  const Eigen::VectorXd& c) {
  world::JointDrive drive{};
  drive.tick = 1;
  drive.enabled = 1;
  drive.joint_count = static_cast<std::uint32_t>(tau.size());
  for (Eigen::Index i = 0; i < tau.size(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    drive.torque[row] = tau[i];
    drive.bias[row] = c[i];
    for (Eigen::Index j = 0; j < tau.size(); ++j) {
      drive.rotor_inertia[row * kMaxJoints + static_cast<std::size_t>(j)] = b(i, j);
      drive.damping[row * kMaxJoints + static_cast<std::size_t>(j)] = d(i, j);
    }
  }
  return drive;
}

}  // namespace mrroc::sim
