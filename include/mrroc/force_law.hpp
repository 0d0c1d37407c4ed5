#pragma once

#include <array>

#include "mrroc/types.hpp"

namespace mrroc {

/// How one axis of the tool frame moves in a force motion (the original's behaviours).
enum class AxisBehaviour : std::uint8_t {
  unguarded = 0,  ///< with the commanded velocity, at any force
  guarded = 1,    ///< with the commanded velocity, giving way to force: the desired force is 0
  contact = 2     ///< towards the desired force: the commanded velocity is 0
};

/// The force law of the task frame formalism, for each axis i of the tool frame: x, y, z (m, N), then the rotations
/// about them (rad, N m). F is the wrench that the environment exerts on the tool, in tool axes and about the tool
/// frame's origin; the tool moves in a servo period dt by
///
///   delta_i = ((b_i (F_i - Fd_i) + v_i) dt^2 + b_i m_i delta_i') / (dt + b_i m_i)
///
/// delta_i': the increment of the previous period, b: admittance, m: inertia, Fd: desired wrench, v: commanded
/// velocity. The result is the velocity v + b (F - Fd) after a low-pass filter of time constant b m. Unguarded: b = m =
/// 0. Guarded: Fd = 0. Contact: v = 0. Source: MRROC++ 2012, edp_e_manip.cc, 340-440, where F has the opposite sign.
///
/// On a surface of stiffness k the force settles with the poles of m b s^2 + s + b k: without overshoot while 4 b^2 k m
/// < 1. On a surface that recedes at speed u the force is lower by u / b.
struct ForceLaw {
  using Axes = Eigen::Matrix<double, 6, 1>;

  std::array<AxisBehaviour, 6> behaviour{};
  Wrench wrench = Wrench::Zero();                                               ///< Fd, N and N m
  Axes inertia = (Axes() << 20, 20, 20, 0.5, 0.5, 0.5).finished();              ///< m, kg and kg m^2
  Axes admittance = (Axes() << 0.005, 0.005, 0.005, 0.1, 0.1, 0.1).finished();  ///< b, m/(N s), rad/(N m s)

  /// Makes axis `axis` give way to force. Throws std::out_of_range unless it is 0..5.
  ForceLaw& guarded(int axis) {
    behaviour.at(static_cast<std::size_t>(axis)) = AxisBehaviour::guarded;
    return *this;
  }
  /// Makes axis `axis` control the wrench component `desired` (N, N m) of the environment on the tool: pressing with 10
  /// N along +z is -10. Throws std::out_of_range unless `axis` is 0..5.
  ForceLaw& contact(int axis, double desired) {
    behaviour.at(static_cast<std::size_t>(axis)) = AxisBehaviour::contact;
    wrench[axis] = desired;
    return *this;
  }
};

}  // namespace mrroc
