#include "mrroc/errors.hpp"

#include <gtest/gtest.h>

namespace mrroc {
namespace {

TEST(Errors, MessageContainsClassCodeDetailAndOrigin) {
  const HardwareError error(ErrorCode::following_error, "axis 2: 12.5 rad, at most 10", {"arm_edp", "arm", 3, 120});
  EXPECT_STREQ(error.what(),
               "hardware error: the following error is too large: axis 2: 12.5 rad, at most 10 "
               "[process arm_edp, device arm, step 3, tick 120]");
  EXPECT_EQ(error.error_class(), ErrorClass::hardware);
  EXPECT_EQ(error.code(), ErrorCode::following_error);
}

TEST(Errors, ThrowErrorThrowsTheGivenClass) {
  EXPECT_THROW(throw_error(ErrorClass::non_fatal, ErrorCode::singular, "", {}), NonFatalError);
  EXPECT_THROW(throw_error(ErrorClass::hardware, ErrorCode::drive_fault, "", {}), HardwareError);
  EXPECT_THROW(throw_error(ErrorClass::system, ErrorCode::link_lost, "", {}), SystemError);
}

}  // namespace
}  // namespace mrroc
