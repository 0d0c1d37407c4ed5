#pragma once

#include <vector>

#include "calibration/hand_eye.hpp"

namespace mrroc::calibration {

/// `whole`, the estimate of an arm with errors of its own from `views`, for a controller that does not know them: the
/// poses of camera and marker are those with which `model` explains best what this arm sees from the postures of the
/// views, in the middle of its play and with exact pictures. The errors of the arm are in them, those of the pictures
/// and of the focal length are not. The rest is that of `whole`, also the deviations: they count what no view shows of
/// the arm, such as the zero of its last joint, which the poses here contain. Throws as `fit_hand_eye`. Any thread;
/// allocates.
HandEyeFit as_computed(const RobotModel& model, const std::vector<MarkerView>& views, HandEyeFit whole);

}  // namespace mrroc::calibration
