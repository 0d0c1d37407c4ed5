#pragma once

#include <Eigen/Core>

namespace mrroc {

/// The polynomial of degree five in s of 0..length that has a given value, first and second derivative at both ends.
/// Two of them that share an end are joined without a step of the second derivative. A cubic's ends give that cubic.
/// Any thread; allocates nothing with rows of fixed number or limit, never throws.
template <int Rows, int MaxRows = Rows>
class QuinticPiece {
 public:
  using Vector = Eigen::Matrix<double, Rows, 1, Eigen::ColMajor, MaxRows, 1>;
  /// Value and derivatives by s.
  struct State {
    Vector value, first, second;
  };

  QuinticPiece(const State& from, const State& to, double length) : length_(length) {
    c0_ = from.value;
    c1_ = length * from.first;
    c2_ = (0.5 * length * length) * from.second;
    const Vector value = to.value - c0_ - c1_ - c2_;
    const Vector first = length * to.first - c1_ - 2 * c2_;
    const Vector second = (length * length) * to.second - 2 * c2_;
    c3_ = 10 * value - 4 * first + 0.5 * second;
    c4_ = -15 * value + 7 * first - second;
    c5_ = 6 * value - 3 * first + 0.5 * second;
  }

  double length() const noexcept { return length_; }
  State at(double s) const noexcept {
    const double u = s / length_;
    return {c0_ + u * (c1_ + u * (c2_ + u * (c3_ + u * (c4_ + u * c5_)))),
            (c1_ + u * (2 * c2_ + u * (3 * c3_ + u * (4 * c4_ + u * 5 * c5_)))) / length_,
            (2 * c2_ + u * (6 * c3_ + u * (12 * c4_ + u * 20 * c5_))) / (length_ * length_)};
  }
  /// The third derivative.
  Vector third(double s) const noexcept {
    const double u = s / length_;
    return (6 * c3_ + u * (24 * c4_ + u * 60 * c5_)) / (length_ * length_ * length_);
  }

 private:
  double length_;
  Vector c0_, c1_, c2_, c3_, c4_, c5_;
};

}  // namespace mrroc
