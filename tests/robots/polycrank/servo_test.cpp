#include <gtest/gtest.h>

#include "robots/common/drive_model.hpp"
#include "robots/polycrank/polycrank_fixture.hpp"

namespace mrroc::servo_test {
namespace {

// the links' inertia at the shafts is up to three times that of the rotors (gravity_test)
TEST(PolycrankServo, TracksARaisedCosineOnTheDrivesModelWithAndWithoutTheLinks) {
  for (const AxisParameters& axis : polycrank_model().parameters().axes) {
    for (const double load : {0.0, 3 * axis.rotor_inertia}) {
      const Tracking result = track_by_servo(axis, 0, load);
      std::printf("%-9s load %.1e kg m^2: worst %.3f rad, final %.1e rad, peak %.3f A\n", axis.name.c_str(), load,
                  result.worst, result.final, result.peak_current);
      EXPECT_GT(result.worst, 0.02) << axis.name;
      EXPECT_LT(result.worst, 0.12) << axis.name;
      EXPECT_LT(result.final, 2 * M_PI / axis.encoder_increments) << axis.name;
      EXPECT_LT(result.peak_current, axis.current_max / 3) << axis.name;
    }
  }
}

// a simulator or a bus with its own clock acts up to one tick late
TEST(PolycrankServo, EveryAxisToleratesATickOfDelay) {
  for (const AxisParameters& axis : polycrank_model().parameters().axes) {
    for (const double load : {0.0, 3 * axis.rotor_inertia}) {
      const Tracking result = track_by_servo(axis, 1, load);
      EXPECT_LT(result.worst, 0.12) << axis.name << ' ' << load;
      EXPECT_LT(result.final, 2 * 2 * M_PI / axis.encoder_increments) << axis.name << ' ' << load;
    }
  }
}

}  // namespace
}  // namespace mrroc::servo_test
