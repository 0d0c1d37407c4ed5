#include "regulation/servo_loop.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace mrroc::regulation {

namespace {

constexpr int kFrequencies = 20000;
constexpr double kLowest = 1e-4;  // of the Nyquist frequency

using Polynomial = std::vector<double>;  // of z^-1, from the constant on

Polynomial product(const Polynomial& one, const Polynomial& other) {
  Polynomial result(one.size() + other.size() - 1, 0.0);
  for (std::size_t i = 0; i < one.size(); ++i)
    for (std::size_t j = 0; j < other.size(); ++j) result[i + j] += one[i] * other[j];
  return result;
}

}  // namespace

ServoLoop::ServoLoop(const AxisParameters& axis, double inertia, double period) noexcept
    : period_(period),
      gain_(axis.regulator_current_gain * axis.encoder_increments / (2 * std::numbers::pi)),
      a_(axis.regulator_a),
      b0_(axis.regulator_b0),
      b1_(axis.regulator_b1),
      eps_(axis.regulator_eps) {
  const double rate = axis.viscous_friction / inertia;  // of the velocity's decay, 1/s
  const double x = rate * period;
  decay_ = std::exp(-x);
  // T and T^2/2 where the friction vanishes
  const double travel = x < 1e-6 ? period * (1 - x / 2) : -std::expm1(-x) / rate;
  const double sag = x < 1e-4 ? period * period * (0.5 - x / 6) : (period - travel) / rate;
  const double acceleration = axis.torque_constant / inertia;  // of 1 A
  near_ = acceleration * sag;
  far_ = acceleration * (travel * travel - sag * decay_);
}

std::complex<double> ServoLoop::open(double rate) const noexcept {
  const std::complex<double> d = std::polar(1.0, -rate * period_);
  const std::complex<double> law =
      gain_ * (b0_ - b1_ * d) * ((1 + eps_) - (1 - eps_) * d) / ((1.0 - d) * (1.0 - a_ * d));
  return law * d * (near_ * d + far_ * d * d) / ((1.0 - d) * (1.0 - decay_ * d));
}

bool ServoLoop::stable() const {
  Polynomial closed = product(product({1, -1}, {1, -a_}), product({1, -1}, {1, -decay_}));
  Polynomial forward = product(product({gain_ * b0_, -gain_ * b1_}, {1 + eps_, eps_ - 1}), {0, 0, near_, far_});
  closed.resize(std::max(closed.size(), forward.size()), 0.0);
  for (std::size_t i = 0; i < forward.size(); ++i) closed[i] += forward[i];
  const auto degree = static_cast<Eigen::Index>(closed.size()) - 1;
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
  companion.diagonal(-1).setOnes();
  for (Eigen::Index i = 0; i < degree; ++i) companion(0, i) = -closed[static_cast<std::size_t>(i) + 1] / closed[0];
  return companion.eigenvalues().cwiseAbs().maxCoeff() < 1;
}

LoopMargins ServoLoop::margins() const {
  LoopMargins margins{.stable = stable(),
                      .crossover = 0,
                      .phase_margin = std::numeric_limits<double>::infinity(),
                      .gain_increase = std::numeric_limits<double>::infinity(),
                      .gain_decrease = 0};
  const double nyquist = std::numbers::pi / period_;
  std::complex<double> before = open(kLowest * nyquist);
  for (int i = 1; i < kFrequencies; ++i) {
    const double rate = nyquist * std::pow(kLowest, 1 - static_cast<double>(i) / kFrequencies);
    const std::complex<double> here = open(rate);
    if ((std::abs(before) > 1) != (std::abs(here) > 1)) {
      margins.crossover = rate / (2 * std::numbers::pi);
      margins.phase_margin = std::min(margins.phase_margin, std::abs(std::arg(-here)));
    }
    // through the negative real axis
    if (here.real() < 0 && before.imag() * here.imag() < 0) {
      const double size = std::abs(here);
      if (size < 1) margins.gain_increase = std::min(margins.gain_increase, 1 / size);
      if (size > 1) margins.gain_decrease = std::max(margins.gain_decrease, 1 / size);
    }
    before = here;
  }
  return margins;
}

}  // namespace mrroc::regulation
