#include "drivers/socketcan/drive_fault.hpp"

#include <gtest/gtest.h>

namespace mrroc::edp {
namespace {

/// One fault of each kind, with the longest texts that it may have.
std::vector<DriveFault> one_of_each() {
  return {Restarted{},
          SetupRefused{{0x6085, 255}, canopen::SdoAbort{0x06040043}},
          DuplicateNode{1000},
          Silent{Silent::How::no_answer, 1000},
          Silent{Silent::How::late, 1000},
          Silent{Silent::How::no_status, 1000},
          HeartbeatLost{1'000'000'000, 1000},
          DriveError{0},
          DriveError{0x7305},
          DriveError{0xffff},
          WrongState{0x0637},
          WrongMode{{}, canopen::DriveMode::cyclic_position},
          WrongMode{-128, canopen::DriveMode::cyclic_position},
          NotFollowing{}};
}

TEST(DriveFault, NoFaultIsEmpty) {
  EXPECT_EQ(code_of({}), ErrorCode::none);
  EXPECT_TRUE(describe(DriveFault{}).empty());
}

TEST(DriveFault, EachKindHasACodeAndAllButARestartACompleteSentence) {
  for (const DriveFault& fault : one_of_each()) {
    SCOPED_TRACE(fault.index());
    EXPECT_NE(code_of(fault), ErrorCode::none);
    const std::string_view text = describe(fault).view();
    EXPECT_EQ(text.empty(), std::holds_alternative<Restarted>(fault));
    EXPECT_LT(text.size(), 127u) << text;
  }
}

TEST(DriveFault, ValuesKeepTheirTypes) {
  EXPECT_EQ(describe(DriveFault(DriveError{0x7305})).view().substr(0, 17), "error code 7305h,");
  EXPECT_EQ(describe(DriveFault(SetupRefused{{0x6085, 2}, canopen::SdoAbort::no_such_object})).view().substr(0, 41),
            "it refuses to be set up: object 6085h:2, ");
  EXPECT_EQ(describe(DriveFault(WrongMode{1, canopen::DriveMode::cyclic_position})).view(), "mode display 1, wanted 8");
  EXPECT_EQ(describe(DriveFault(WrongMode{{}, canopen::DriveMode::cyclic_position})).view(),
            "no answer with its mode display (6061h), wanted 8");
}

}  // namespace
}  // namespace mrroc::edp
