#include "edp/safety/fault.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "edp/safety/error_report.hpp"
#include "edp/test_robots.hpp"

namespace mrroc::edp::fault_test {
namespace {

std::string report(const Fault& fault) { return std::string(make_report(fault, Slide{}.parameters()).detail.view()); }

TEST(Fault, ReportsAxisNameAndTick) {
  EXPECT_EQ(report({ErrorCode::following_error, 0, Excess{31.5, 30}, 7}), "axis 1 (x), tick 7: 31.5, limit 30");
  EXPECT_EQ(report({ErrorCode::limit_switch, 0, ShaftPosition{-2.25}, 7}),
            "axis 1 (x), tick 7: at -2.25 rad of the shaft");
  EXPECT_EQ(report({ErrorCode::bus_off, -1, DriverText("bus off"), 7}), "at tick 7: bus off");
}

TEST(Fault, WithoutADetailItReportsWhereAndWhen) {
  EXPECT_EQ(report({ErrorCode::drive_fault, 0, {}, 12}), "axis 1 (x), tick 12");
  EXPECT_EQ(report({ErrorCode::emergency_stop, -1, {}, 12}), "at tick 12");
}

TEST(Fault, DistinguishesAValueFromItsLimit) {
  EXPECT_EQ(describe(Excess{1 + 1e-9, 1}).view(), "1.000000001, limit 1");
  EXPECT_EQ(describe(Excess{2, 1}).view(), "2, limit 1");
}

TEST(Fault, NonFiniteReadingIsNoExcess) {
  EXPECT_EQ(report({ErrorCode::encoder_fault, 0, NotFinite{}, 3}),
            "axis 1 (x), tick 3: its reading is not a finite number");
}

TEST(Fault, LongTextIsCut) {
  const std::string longest(300, 'x');
  EXPECT_EQ(driver_text("%s", longest.c_str()).view(), longest.substr(0, 127));
}

}  // namespace
}  // namespace mrroc::edp::fault_test
