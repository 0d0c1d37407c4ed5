#include "cli/operator/verb_request.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace mrroc::cli::verb_request_test {
namespace {

Refusal typed(const std::string& line) {
  VerbReply refusal;
  return parse_typed(line, refusal) ? Refusal::none : refusal.refusal;
}

Refusal sent(const std::string& line) {
  VerbReply refusal;
  return parse_json(line, refusal) ? Refusal::none : refusal.refusal;
}

TEST(VerbRequest, TypedLineIsAVerbAndItsArguments) {
  VerbReply refusal;
  EXPECT_EQ(parse_typed(" pause \r", refusal)->verb->name, "pause");
  const auto answer = parse_typed("answer from=mp  left side ", refusal);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->argument("from"), "mp");
  EXPECT_EQ(answer->argument("value"), "left side");
  EXPECT_EQ(parse_typed("answer from mp", refusal)->argument("value"), "from mp");
  const auto jog = parse_typed("jog arm rz -0.1 in=tool", refusal);
  ASSERT_TRUE(jog);
  EXPECT_EQ(jog->argument("axis"), "rz");
  EXPECT_EQ(jog->argument("velocity"), "-0.1");
  EXPECT_EQ(jog->argument("in"), "tool");
  for (const char* line : {"answer", "pause now", "answer from=mp", "answer from= 3"})
    EXPECT_EQ(typed(line), Refusal::invalid_argument) << line;
  for (const char* line : {"", " ", "Pause!", "x", "pausee resume"})
    EXPECT_EQ(typed(line), Refusal::unknown_verb) << line;
}

TEST(VerbRequest, UnknownVerbNamesTheNearest) {
  VerbReply refusal;
  EXPECT_FALSE(parse_typed("puase", refusal));
  EXPECT_NE(refusal.text.find("did you mean 'pause'?"), std::string::npos) << refusal.text;
  EXPECT_FALSE(parse_typed("frobnicate", refusal));
  EXPECT_NE(refusal.expected.find("'estop'"), std::string::npos) << refusal.expected;
}

TEST(VerbRequest, SentLineIsAJsonObject) {
  VerbReply refusal;
  const auto answer = parse_json(R"({"verb": "answer", "value": 3, "from": "parts", "id": -7})", refusal);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->argument("value"), "3");
  EXPECT_EQ(answer->id, -7);
  EXPECT_EQ(parse_json(R"({"verb":"answer","value":true})", refusal)->argument("value"), "yes");
  for (const char* line :
       {"", "pause", "[]", "3", "null", "{", R"({"verb":3})", R"({"id":1})", R"({"verb":"pause","id":"x"})",
        R"({"verb":"pause","id":1.5})", R"({"verb":"pause","id":18446744073709551615})",
        R"({"verb":"answer","value":{"a":1}})", R"({"verb":"answer","value":null})", "{\"verb\":\"pau\xff\"}",
        R"({"verb":"pause"} {"verb":"pause"})"})
    EXPECT_EQ(sent(line), Refusal::malformed) << line;
  EXPECT_EQ(sent(R"({"verb":"Pause"})"), Refusal::unknown_verb);
  for (const char* line : {R"({"verb":"answer"})", R"({"verb":"pause","now":1})", R"({"verb":"answer","value":""})"})
    EXPECT_EQ(sent(line), Refusal::invalid_argument) << line;
  EXPECT_EQ(sent(R"({"verb":"answer","value":")" + std::string(300, 'x') + "\"}"), Refusal::invalid_argument);
  EXPECT_EQ(sent(std::string(10000, '[')), Refusal::malformed);
  EXPECT_EQ(sent(R"({"verb":"status","x":)" + std::string(5000, '[') + std::string(5000, ']') + "}"),
            Refusal::malformed);
}

TEST(VerbRequest, FilesHaveThePathsOfTheSystem) {
  VerbReply refusal;
  const auto typed = parse_typed("record my runs/last steps.mcap", refusal);
  ASSERT_TRUE(typed) << to_text(refusal);
  EXPECT_EQ(typed->argument("file"), "my runs/last steps.mcap");
  EXPECT_TRUE(parse_json(R"({"verb":"record","file":")" + std::string(4096, 'x') + "\"}", refusal));
  EXPECT_EQ(sent(R"({"verb":"record","file":")" + std::string(4097, 'x') + "\"}"), Refusal::invalid_argument);
  EXPECT_EQ(sent(R"({"verb":"record","file":"a\u0000b"})"), Refusal::invalid_argument);
  EXPECT_EQ(sent(R"({"verb":"record"})"), Refusal::invalid_argument);
}

TEST(VerbRequest, RefusalRepeatsTheNumberOfTheRequest) {
  VerbReply refusal;
  EXPECT_FALSE(parse_json(R"({"verb":"paus","id":12})", refusal));
  EXPECT_EQ(refusal.id, 12);
}

TEST(VerbRequest, AnyTextIsParsedOrRefusedWithAReason) {
  EXPECT_TRUE(rc::check([](const std::string& text) {
    for (const auto parse : {parse_typed, parse_json}) {
      VerbReply refusal;
      if (parse(text, refusal)) continue;
      RC_ASSERT(!refusal.ok());
      RC_ASSERT(!refusal.text.empty());
      const std::string json = to_json(refusal);
      RC_ASSERT(json.find('\n') == std::string::npos);
      RC_ASSERT(parse_reply(json).has_value());
    }
  }));
}

TEST(VerbReply, ReplySurvivesItsLine) {
  VerbReply reply;
  reply.text = "\"quoted\"\nline";
  reply.tick = 12;
  reply.id = 3;
  reply.data = R"({"a":[1,2]})";
  const auto read = parse_reply(to_json(reply));
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->ok());
  EXPECT_EQ(read->text, reply.text);
  EXPECT_EQ(read->tick, reply.tick);
  EXPECT_EQ(read->id, reply.id);
  EXPECT_EQ(read->data, reply.data);
  for (const Refusal refusal : {Refusal::malformed, Refusal::unknown_verb, Refusal::invalid_argument,
                                Refusal::not_allowed, Refusal::not_commander, Refusal::ended}) {
    reply.refusal = refusal;
    EXPECT_EQ(parse_reply(to_json(reply))->refusal, refusal);
  }
  EXPECT_FALSE(parse_reply(R"({"event":"end"})"));
  EXPECT_FALSE(parse_reply("x"));
}

}  // namespace
}  // namespace mrroc::cli::verb_request_test
