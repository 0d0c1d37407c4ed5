#include "calibration/as_computed.hpp"

namespace mrroc::calibration {

namespace {

constexpr HandEyePriors kExact{.joint = 1e-9, .focal = 1e-9, .k1 = 1e-9, .play = 1e-9};

}  // namespace

HandEyeFit as_computed(const RobotModel& model, const std::vector<MarkerView>& views, HandEyeFit whole) {
  std::vector<MarkerView> exact = views;
  for (MarkerView& view : exact) {
    view.approach = 0;
    view.marker = expected_marker(model, whole, view);
  }
  const HandEyeFit computed = fit_hand_eye(model, exact, kExact, whole.carried);
  whole.camera = computed.camera;
  whole.marker = computed.marker;
  return whole;
}

}  // namespace mrroc::calibration
