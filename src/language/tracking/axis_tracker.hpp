#pragma once

#include <array>
#include <memory>

namespace mrroc {

struct AxisMotion {
  double position = 0, velocity = 0, acceleration = 0;
};

/// Limits of magnitudes, above 0.
struct AxisBounds {
  double velocity = 0, acceleration = 0, jerk = 0;
};

/// One axis on its way to position 0 at rest, in periods of constant jerk. One thread; `jerk` does not allocate.
class AxisTracker {
 public:
  /// `step`: length of a period, s.
  explicit AxisTracker(double step);
  ~AxisTracker();
  AxisTracker(AxisTracker&&) noexcept;

  /// The jerk of the coming period from `from`: that of a sequence of at most kMost periods that lands on 0 within the
  /// bounds, if one exists that takes hardly longer than the time-optimal motion; else the mean jerk of that motion
  /// with a part of the bounds.
  double jerk(const AxisMotion& from, const AxisBounds& bounds) const noexcept;
  /// The end of a period with this jerk.
  AxisMotion after(const AxisMotion& from, double jerk) const noexcept;

  static constexpr int kMost = 24;

 private:
  struct Online;
  using Jerks = std::array<double, kMost>;
  /// The time-optimal motion; false: none was found.
  bool plan(const AxisMotion& from, const AxisBounds& bounds) const noexcept;
  bool plan_with_reserve(const AxisMotion& from, const AxisBounds& bounds, double longest) const noexcept;
  bool passes_target(const AxisMotion& from) const noexcept;
  bool lands(const AxisMotion& from, const AxisBounds& bounds, int periods, Jerks& jerks) const noexcept;
  void solve(const AxisMotion& from, int periods, Jerks& jerks) const noexcept;

  double step_;
  std::unique_ptr<Online> online_;
};

}  // namespace mrroc
