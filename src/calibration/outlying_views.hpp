#pragma once

#include <cstddef>
#include <vector>

#include "calibration/hand_eye.hpp"

namespace mrroc::calibration {

/// An estimate from the views that agree with each other.
struct AgreedFit {
  HandEyeFit fit;
  std::vector<std::size_t> used;      ///< numbers of its views, from 0; `fit.residuals` are of these
  std::vector<std::size_t> left_out;  ///< the others
};

/// `fit_hand_eye` without views that contradict the others, because a corner of the marker was covered or its mirrored
/// pose was taken: those whose residual is more than kOutlying times the median, the largest first, at most a fifth of
/// the views. Twice: with the closed form of few views that has the smallest median residual of all (least median of
/// squares, P. J. Rousseeuw, J. Amer. Statist. Assoc. 79, 1984; seeded), which a wrong view does not spoil; then with
/// the estimate itself. Throws as `fit_hand_eye`. Any thread; allocates.
AgreedFit fit_of_agreeing_views(const RobotModel& model, const std::vector<MarkerView>& views,
                                const HandEyePriors& priors, Carried carried = Carried::camera);

inline constexpr double kOutlying = 4;

}  // namespace mrroc::calibration
