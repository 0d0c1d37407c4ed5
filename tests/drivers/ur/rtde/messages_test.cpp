#include "drivers/ur/rtde/messages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/ur/rtde/protocol_error.hpp"

namespace mrroc::ur::rtde::messages_test {
namespace {

using Stream = std::vector<std::uint8_t>;
using testing::HasSubstr;

template <class Message>
void refuses_every_other_length(const Message& message, bool ends_with_text) {
  Stream payload = message.payload();
  if (!ends_with_text) {
    for (std::size_t size = 0; size < payload.size(); ++size)
      EXPECT_THROW(Message::from_payload(Bytes(payload).first(size)), ProtocolError) << size;
    payload.push_back(0);
    EXPECT_THROW(Message::from_payload(payload), ProtocolError);
  }
}

TEST(Messages, RoundTrip) {
  EXPECT_EQ(VersionRequest::from_payload(VersionRequest{}.payload()).version, 2);
  EXPECT_TRUE(Acceptance::from_payload(Acceptance{true}.payload()).accepted);
  EXPECT_FALSE(Acceptance::from_payload(Acceptance{false}.payload()).accepted);
  const ControllerVersion version{5, 11, 1, 108318};
  EXPECT_EQ(ControllerVersion::from_payload(version.payload()), version);
  EXPECT_EQ(describe(version), "5.11.1.108318");
  const TextMessage text{"a text", "a source", TextMessage::Level::warning};
  const TextMessage read = TextMessage::from_payload(text.payload());
  EXPECT_EQ(read.message, text.message);
  EXPECT_EQ(read.source, text.source);
  EXPECT_EQ(read.level, text.level);
  const OutputsRequest outputs = OutputsRequest::from_payload(OutputsRequest{500, {"timestamp", "actual_q"}}.payload());
  EXPECT_EQ(outputs.frequency, 500);
  EXPECT_EQ(outputs.names, (std::vector<std::string>{"timestamp", "actual_q"}));
  EXPECT_EQ(InputsRequest::from_payload(InputsRequest{{"a_1"}}.payload()).names, std::vector<std::string>{"a_1"});
  const SetupReply reply = SetupReply::from_payload(SetupReply{3, {"DOUBLE", "VECTOR6D"}}.payload());
  EXPECT_EQ(reply.id, 3);
  EXPECT_EQ(reply.types, (std::vector<std::string>{"DOUBLE", "VECTOR6D"}));
}

TEST(Messages, EveryOtherLengthIsRefused) {
  refuses_every_other_length(VersionRequest{}, false);
  refuses_every_other_length(Acceptance{}, false);
  refuses_every_other_length(ControllerVersion{5, 11, 1, 2}, false);
  refuses_every_other_length(TextMessage{"text", "source", TextMessage::Level::error}, false);
  EXPECT_THROW(OutputsRequest::from_payload(Stream(7)), ProtocolError);
  EXPECT_THROW(SetupReply::from_payload({}), ProtocolError);
}

TEST(Messages, FlippedLengthsOfATextAreRefused) {
  const Stream payload = TextMessage{"text", "source", TextMessage::Level::error}.payload();
  for (const std::size_t at : {std::size_t{0}, std::size_t{5}})
    for (int bit = 0; bit < 8; ++bit) {
      Stream flipped = payload;
      flipped[at] = static_cast<std::uint8_t>(flipped[at] ^ (1 << bit));
      EXPECT_THROW(TextMessage::from_payload(flipped), ProtocolError) << at << ' ' << bit;
    }
}

TEST(Messages, NamesOfOtherCharactersAreRefused) {
  EXPECT_THROW(InputsRequest::from_payload(InputsRequest{{"a b"}}.payload()), ProtocolError);
  EXPECT_THROW(InputsRequest::from_payload(InputsRequest{{"a", "", "b"}}.payload()), ProtocolError);
  EXPECT_THROW(SetupReply::from_payload(SetupReply{1, {"DOUB\nLE"}}.payload()), ProtocolError);
}

std::string problem_of(const SetupReply& reply, const std::vector<std::string>& names) {
  try {
    accepted_recipe(reply, names);
  } catch (const ProtocolError& error) {
    return error.what();
  }
  return "";
}

TEST(AcceptedRecipe, NamesEveryRefusedField) {
  const std::string problem = problem_of({0, {"NOT_FOUND", "DOUBLE", "IN_USE", "NOT_FOUND", "QUATERNION"}},
                                         {"first", "second", "third", "fourth", "fifth"});
  EXPECT_THAT(problem, HasSubstr("first, fourth"));
  EXPECT_THAT(problem, HasSubstr("writes: third"));
  EXPECT_THAT(problem, HasSubstr("fifth (QUATERNION)"));
  EXPECT_THAT(problem, testing::Not(HasSubstr("second")));
}

TEST(AcceptedRecipe, CountsFields) {
  EXPECT_NE(problem_of({1, {"DOUBLE"}}, {"a", "b"}), "");
  EXPECT_NE(problem_of({0, {"DOUBLE"}}, {"a"}), "");
  const std::vector<std::string> names{"a", "b"};
  const Recipe recipe = accepted_recipe({1, {"DOUBLE", "UINT8"}}, names);
  EXPECT_EQ(recipe.types, (std::vector<FieldType>{FieldType::real, FieldType::uint8}));
  EXPECT_EQ(recipe.size(), 10u);
}

}  // namespace
}  // namespace mrroc::ur::rtde::messages_test
