#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "messages/message_table.hpp"
#include "messages/mrroc_msgs/step.hpp"
#include "messages/sensor_msgs/joint_state.hpp"

namespace mrroc::messages::cdr_test {

namespace {

using Bytes = std::vector<std::byte>;

Bytes bytes_of(std::initializer_list<int> values) {
  Bytes bytes;
  for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
  return bytes;
}

mrroc_msgs::Step example_step() {
  mrroc_msgs::Step step;
  step.tick = 248;
  step.process = "arm";
  step.until = {"force"};
  step.robots.resize(2);
  step.robots[0].joints = {1, 2, 3};
  step.robots[0].command.resize(1);
  step.sensors.resize(1);
  step.sensors[0].values = {0.5};
  step.conditions.resize(3);
  step.skew = {4};
  return step;
}

TEST(Cdr, EncodesAsInTheStandardsExample) {
  builtin_interfaces::Time time;
  time.sec = 1;
  time.nanosec = 0x01020304;
  EXPECT_EQ(to_cdr(time), bytes_of({0, 1, 0, 0, 1, 0, 0, 0, 4, 3, 2, 1}));
  EXPECT_EQ(from_cdr<builtin_interfaces::Time>(bytes_of({0, 0, 0, 0, 0, 0, 0, 1, 1, 2, 3, 4})), time);
  mrroc_msgs::Condition condition;
  condition.name = "ab";
  condition.holds = true;
  EXPECT_EQ(to_cdr(condition), bytes_of({0, 1, 0, 0, 3, 0, 0, 0, 'a', 'b', 0, 1}));
}

TEST(Cdr, StepReadsBackAsItWasWritten) {
  const mrroc_msgs::Step step = example_step();
  EXPECT_EQ(from_cdr<mrroc_msgs::Step>(to_cdr(step)), step);
}

TEST(Cdr, RefusesEveryPrefix) {
  const Bytes whole = to_cdr(example_step());
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THROW(from_cdr<mrroc_msgs::Step>(std::span(whole).first(size)), CdrError) << size;
}

std::string refusal_of(const Bytes& bytes) {
  try {
    from_cdr<sensor_msgs::JointState>(bytes);
  } catch (const CdrError& error) {
    return error.what();
  }
  return "";
}

TEST(Cdr, RefusesLengthsWithoutTheirBytes) {
  // of frame_id
  EXPECT_EQ(refusal_of(bytes_of({0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 0})),
            "CDR: a text of 4294967295 bytes at byte 16, expected at most 1 bytes");
  // of name: 2^31 texts
  EXPECT_EQ(refusal_of(bytes_of({0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 128})),
            "CDR: a sequence of 8589934592 bytes at byte 24, expected at most 0 bytes");
}

TEST(Cdr, RefusesOtherEncodingsAndValues) {
  EXPECT_EQ(refusal_of({}), "CDR of 0 bytes, expected a header of 4");
  EXPECT_EQ(refusal_of(bytes_of({0, 3, 0, 0})), "CDR: encapsulation 3, expected 0 (big-endian) or 1 (little-endian)");
  EXPECT_EQ(refusal_of(bytes_of({0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 'x'})),
            "CDR: byte 16 is 120, expected 0 at the end of a text");
  EXPECT_THROW(from_cdr<mrroc_msgs::Condition>(bytes_of({0, 1, 0, 0, 1, 0, 0, 0, 0, 2})), CdrError);
  mrroc_msgs::Step step = example_step();
  step.until = {"a", "b"};  // more than its bound: the writer leaves the rest out
  EXPECT_EQ(from_cdr<mrroc_msgs::Step>(to_cdr(step)).until, std::vector<std::string>{"a"});
}

/// Of any bytes behind a valid header, a decoder either makes a message that encodes to a message again, or refuses.
RC_GTEST_PROP(Cdr, AnyBytesAreAMessageOrRefused, ()) {
  const auto& types = message_types();
  const MessageType& type = types[*rc::gen::inRange<std::size_t>(0, types.size())];
  Bytes bytes = bytes_of({0, *rc::gen::inRange(0, 2), 0, 0});
  const auto body = *rc::gen::container<std::vector<int>>(
      rc::gen::weightedOneOf<int>({{6, rc::gen::just(0)}, {2, rc::gen::inRange(0, 5)}, {1, rc::gen::inRange(0, 256)}}));
  for (int copies = 0; copies < 8; ++copies)
    for (const int value : body) bytes.push_back(static_cast<std::byte>(value));
  try {
    const Bytes again = type.recode(bytes);
    RC_ASSERT(type.recode(again) == again);
  } catch (const CdrError& refused) {
    RC_ASSERT(std::string{refused.what()}.starts_with("CDR"));
  }
}

}  // namespace

}  // namespace mrroc::messages::cdr_test
