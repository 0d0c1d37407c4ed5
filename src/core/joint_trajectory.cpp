#include "mrroc/joint_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mrroc {

namespace {

constexpr double kLongest = 1e6;  // s: 11 days

bool is_count(double number, std::size_t least, std::size_t most) noexcept {
  return number >= static_cast<double>(least) && number <= static_cast<double>(most) && number == std::floor(number);
}

}  // namespace

JointTrajectory::JointTrajectory(std::size_t axes, Order order, std::size_t points)
    : numbers_(kHead + 2 * axes + points * (1 + axes * static_cast<std::size_t>(order))), size_(numbers_.size()) {
  numbers_[0] = static_cast<double>(axes);
  numbers_[1] = static_cast<double>(order);
  numbers_[2] = static_cast<double>(points);
}

std::size_t JointTrajectory::most_numbers(std::size_t axes) noexcept {
  return kHead + 2 * axes + kMostPoints * (1 + 3 * axes);
}

bool JointTrajectory::receive(std::size_t size, std::size_t begin, std::span<const double> part) {
  if (begin == 0) {
    clear();
    size_ = size;
  }
  if (size != size_ || begin != numbers_.size() || part.size() > size - begin || part.empty()) return false;
  numbers_.insert(numbers_.end(), part.begin(), part.end());
  return true;
}

void JointTrajectory::swap(JointTrajectory& other) noexcept {
  numbers_.swap(other.numbers_);
  std::swap(size_, other.size_);
}

const char* JointTrajectory::problem(std::size_t axes) const noexcept {
  if (!complete() || numbers_.size() < kHead) return "its numbers are incomplete";
  if (!std::all_of(numbers_.begin(), numbers_.end(), [](double number) { return std::isfinite(number); }))
    return "a number is not finite";
  if (numbers_[0] != static_cast<double>(axes)) return "it has another number of axes than the robot";
  if (!is_count(numbers_[1], 1, 3)) return "its order is unknown, expected 1 to 3";
  if (!is_count(numbers_[2], 1, kMostPoints)) return "the number of its points is not 1 to 2000";
  if (numbers_.size() != row(points())) return "it has not as many numbers as its points need";
  if (!std::all_of(numbers_.begin() + 3, numbers_.begin() + static_cast<std::ptrdiff_t>(kHead + 2 * axes),
                   [](double tolerance) { return tolerance >= 0; }))
    return "a tolerance is negative";
  if (time(0) < 0 || duration() > kLongest) return "its times are not from 0 to 1e6 s";
  for (std::size_t point = 1; point < points(); ++point)
    if (!(time(point) > time(point - 1))) return "its times do not rise";
  for (std::size_t axis = 0; order() != Order::positions && axis < axes; ++axis)
    if (velocity(points() - 1, axis) != 0) return "its last point moves, expected velocity 0 there";
  return nullptr;
}

void JointTrajectory::set_point(std::size_t point, double time, std::span<const double> values) noexcept {
  double* const to = numbers_.data() + row(point);
  *to = time;
  std::copy(values.begin(), values.end(), to + 1);
}

void JointTrajectory::set_tolerances(std::span<const double> path, std::span<const double> goal,
                                     double goal_time) noexcept {
  std::copy(path.begin(), path.end(), numbers_.begin() + kHead);
  std::copy(goal.begin(), goal.end(), numbers_.begin() + static_cast<std::ptrdiff_t>(kHead + axes()));
  numbers_[3] = goal_time;
}

}  // namespace mrroc
