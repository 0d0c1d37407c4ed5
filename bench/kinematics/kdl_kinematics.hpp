#pragma once

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainiksolverpos_nr.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <vector>

#include "bench/kinematics/postures.hpp"

namespace mrroc::bench {

/// KDL's answers about postures that are set in advance, so that no conversion is measured. There are two inverses:
/// Levenberg-Marquardt (LMA) with its own settings, converged when the error is below 1e-5 m and 1e-3 rad, and
/// Newton-Raphson on the pseudo-inverse, faster from a near start and often divergent from a far one, below 1e-5 in
/// all. (Damped least squares would halve Newton's time, but abort on a chain of fewer than six joints.)
class KdlKinematics {
 public:
  explicit KdlKinematics(const KDL::Chain& chain);
  KdlKinematics(const KdlKinematics&) = delete;  // the solvers point to the chain
  KdlKinematics& operator=(const KdlKinematics&) = delete;

  void add(const Posture& posture);
  void remove_last();

  // of the posture with this index; the answer stays until the next call
  void direct(std::size_t i) { direct_.JntToCart(postures_[i].joints, pose_); }
  bool lma(std::size_t i) { return solve(lma_, i); }
  bool newton(std::size_t i) { return solve(newton_, i); }
  void jacobian(std::size_t i) { jacobian_.JntToJac(postures_[i].joints, matrix_); }

  Pose pose() const;
  JointVector joints() const { return joints_.data; }
  Jacobian matrix() const { return matrix_.data; }

 private:
  struct Question {
    KDL::JntArray joints;
    KDL::JntArray near;
    KDL::Frame pose;
  };

  bool solve(KDL::ChainIkSolverPos& solver, std::size_t i) {
    return solver.CartToJnt(postures_[i].near, postures_[i].pose, joints_) >= 0;
  }

  KDL::Chain chain_;
  KDL::ChainFkSolverPos_recursive direct_;
  KDL::ChainIkSolverPos_LMA lma_;
  KDL::ChainIkSolverVel_pinv velocity_;
  KDL::ChainIkSolverPos_NR newton_;
  KDL::ChainJntToJacSolver jacobian_;
  std::vector<Question> postures_;
  KDL::Frame pose_;
  KDL::JntArray joints_;
  KDL::Jacobian matrix_;
};

}  // namespace mrroc::bench
