#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "mrroc/types.hpp"

namespace mrroc {

/// Joints of one robot over time, as other programs plan them: points with the time since the start (s), positions (rad
/// or m), and perhaps velocities, or velocities and accelerations; the tolerances within which the robot has to follow.
/// It is kept as one row of numbers, so that it can travel in parts and be stored where nothing may be allocated.
class JointTrajectory {
 public:
  static constexpr std::size_t kMostPoints = 2000;

  /// What is given of each axis at each point.
  enum class Order { positions = 1, velocities = 2, accelerations = 3 };

  JointTrajectory() = default;
  /// Of `points` points, all numbers 0.
  JointTrajectory(std::size_t axes, Order order, std::size_t points);

  /// Numbers of the longest one for a robot with so many axes.
  static std::size_t most_numbers(std::size_t axes) noexcept;
  /// Room for the longest one: from now on `receive` allocates nothing.
  void reserve(std::size_t axes) { numbers_.reserve(most_numbers(axes)); }

  /// Places a part of the numbers of another trajectory, which has `size` of them, from number `begin` on; the first
  /// part begins at 0. False when the part is not the next one.
  bool receive(std::size_t size, std::size_t begin, std::span<const double> part);
  /// All numbers have been received.
  bool complete() const noexcept { return size_ > 0 && numbers_.size() == size_; }
  std::span<const double> numbers() const noexcept { return numbers_; }
  void clear() noexcept { numbers_.clear(), size_ = 0; }
  void swap(JointTrajectory& other) noexcept;

  /// Whether the numbers are a trajectory of a robot with so many axes: its shape, finite numbers, times that rise from
  /// at least 0, tolerances of at least 0, and no velocity given at the end. Null, or what is wrong.
  const char* problem(std::size_t axes) const noexcept;

  // ---- of a trajectory without a problem
  std::size_t axes() const noexcept { return static_cast<std::size_t>(numbers_[0]); }
  Order order() const noexcept { return static_cast<Order>(static_cast<int>(numbers_[1])); }
  std::size_t points() const noexcept { return static_cast<std::size_t>(numbers_[2]); }
  /// Since the start, s.
  double time(std::size_t point) const noexcept { return numbers_[row(point)]; }
  double duration() const noexcept { return time(points() - 1); }
  double position(std::size_t point, std::size_t axis) const noexcept { return numbers_[row(point) + 1 + axis]; }
  double velocity(std::size_t point, std::size_t axis) const noexcept {
    return numbers_[row(point) + 1 + axes() + axis];
  }
  double acceleration(std::size_t point, std::size_t axis) const noexcept {
    return numbers_[row(point) + 1 + 2 * axes() + axis];
  }
  /// Of the measured position from the trajectory's, on the way and at its end; 0: any.
  double path_tolerance(std::size_t axis) const noexcept { return numbers_[kHead + axis]; }
  double goal_tolerance(std::size_t axis) const noexcept { return numbers_[kHead + axes() + axis]; }
  /// How long after its last point the robot may need to be within the tolerance there, s; 0: kGoalTime.
  double goal_time() const noexcept { return numbers_[3]; }
  static constexpr double kGoalTime = 5;

  void set_point(std::size_t point, double time, std::span<const double> values) noexcept;
  void set_tolerances(std::span<const double> path, std::span<const double> goal, double goal_time) noexcept;

 private:
  static constexpr std::size_t kHead = 4;  // axes, order, points, goal time
  std::size_t row(std::size_t point) const noexcept {
    return kHead + 2 * axes() + point * (1 + axes() * static_cast<std::size_t>(order()));
  }

  std::vector<double> numbers_;
  std::size_t size_ = 0;
};

}  // namespace mrroc
