#include "cli/ros2/diagnostics.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace mrroc::cli::diagnostics_test {
namespace {

using Json = nlohmann::ordered_json;
using messages::diagnostic_msgs::DiagnosticStatus;

DiagnosticStatus status_of(const char* event) {
  Diagnostics diagnostics("press");
  diagnostics.take(Json::parse(event));
  return diagnostics.message({}).status.at(0);
}

TEST(Diagnostics, ARobotIsReadyOnlyWithDrivesAndPositions) {
  const auto ready = status_of(R"({"event":"robot","name":"arm","enabled":true,"synchronised":true,"tick":7})");
  EXPECT_EQ(ready.level, DiagnosticStatus::OK);
  EXPECT_EQ(ready.name, "press: robot arm");
  EXPECT_EQ(ready.hardware_id, "arm");
  const auto off = status_of(R"({"event":"robot","name":"arm","enabled":false,"synchronised":true})");
  EXPECT_EQ(off.level, DiagnosticStatus::WARN);
  const auto lost = status_of(R"({"event":"robot","name":"arm","enabled":true,"synchronised":false})");
  EXPECT_EQ(lost.level, DiagnosticStatus::WARN);
}

TEST(Diagnostics, AnErrorIsItsTextWithTheDetail) {
  const auto failed = status_of(
      R"({"event":"process","name":"arm_edp","state":"running","error":{"code":31,"text":"overcurrent","detail":"axis 2"}})");
  EXPECT_EQ(failed.level, DiagnosticStatus::ERROR);
  EXPECT_EQ(failed.message, "overcurrent: axis 2");
}

TEST(Diagnostics, TheNewestStateOfEachNameIsKept) {
  Diagnostics diagnostics("press");
  for (const char* state : {"starting", "running"})
    for (const char* name : {"b", "a"}) diagnostics.take(Json{{"event", "process"}, {"name", name}, {"state", state}});
  const auto message = diagnostics.message({});
  ASSERT_EQ(message.status.size(), 2u);
  EXPECT_EQ(message.status[0].name, "press: process a");
  EXPECT_EQ(message.status[1].message, "running");
}

TEST(Diagnostics, EventsOfAnyContentAreAStatus) {
  for (const char* event : {"{}", R"({"event":"robot"})", R"({"event":"process","error":"text"})",
                            R"({"event":"process","error":{}, "tick":null})"})
    EXPECT_NO_THROW(status_of(event)) << event;
}

}  // namespace
}  // namespace mrroc::cli::diagnostics_test
