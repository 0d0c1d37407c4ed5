#include "cli/trace/parse_line.hpp"

#include <gtest/gtest.h>

#include "cli/trace/format_line.hpp"
#include "cli/trace/trace_text.hpp"
#include "language/property.hpp"

namespace mrroc::cli::trace::parse_line_test {
namespace {

constexpr std::size_t kLongest = 16384;

std::string message_of(const std::string& text) {
  try {
    parse_line(text, kLongest);
  } catch (const Malformed& malformed) {
    return malformed.what();
  }
  return "";
}

TEST(ParseLine, ReadsEveryFieldToTheLastBit) {
  for (const Item& item : example_trace().items) {
    const Line* line = std::get_if<Line>(&item);
    if (line == nullptr) continue;
    EXPECT_EQ(format_line(parse_line(format_line(*line), kLongest)), format_line(*line));
  }
}

TEST(ParseLine, ReadsRareFields) {
  const std::string text =
      "tick=9 process=mp instruction=3 move=\"a \"quoted\" name\" until=\"x or y\" step=4 held=2 robot=arm tick=9 "
      "macrostep=1 joints=1e-07,-2.5 pose=0,0,0,0,1,0,0 desired_tick=11 desired=0,0 desired_pose=0,0,0,0,0,0,-1 moving "
      "late=3 wrench=1,2,3,4,5,6 error=\"hardware error: a drive reports a fault\" "
      "command=motor,relative,motors,N20,v21,start12:1,2 robot=b tick=1 macrostep=1 joints= pose=0,0,0,1,0,0,0 "
      "desired_tick=1 desired= desired_pose=0,0,0,1,0,0,0 command=force,N1,v1:0,0,0,0,0,0,ugcu?c,1,2,3,4,5,inf "
      "sensor=s "
      "tick=0 values= polled sensor=t tick=2 values=nan,inf period=3 published error=\"system error: a process died\" "
      "condition=\"x\":1 condition=\"a \"quoted\" y\":0 end=system_error skew=7";
  const Line line = parse_line(text, kLongest);
  EXPECT_EQ(format_line(line), text);
  EXPECT_EQ(line.name, "a \"quoted\" name");
  EXPECT_EQ(line.robots[0].command->start_tick, 12U);
  EXPECT_EQ(line.robots[1].command->behaviour, "ugcu?c");
  EXPECT_EQ(line.sensors[1].mode, SensorMode::published);
  EXPECT_EQ(line.sensors[1].error, ErrorClass::system);
  EXPECT_EQ(line.conditions[1].name, "a \"quoted\" y");
  EXPECT_EQ(line.skew, 7U);
}

TEST(ParseLine, RefusesInvalidFieldsWithValueAndExpectation) {
  const std::string head = "tick=1 process=arm instruction=1 wait=\"gate\" step=0";
  const std::string state = " robot=arm tick=1 macrostep=0 joints=0 pose=0,0,0,1,0,0,0 desired_tick=2 desired=0";
  const std::string robot = state + " desired_pose=0,0,0,1,0,0,0";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "tick: '', expected 'tick='"},
      {"tick=x process=arm", "tick: 'x', expected a whole number, not negative"},
      {"tick=-1 process=arm", "tick: '-1', expected a whole number"},
      {"tick=1 process= instruction=1", "process: '', expected a name"},
      {"tick=1 process=arm instruction=1 hold=\"gate\" step=0", "move or wait: "},
      {"tick=1 process=arm instruction=1 wait=\"gate", "name: 'gate', expected a text with '\" step='"},
      {head + "1x", "step: '01x', expected a whole number"},
      {head + " held=many", "held: 'many', expected"},
      {head + " robot=arm tick=1 joints=0", "robot: ' joints=0', expected ' macrostep='"},
      {head + " robot=arm tick=1 macrostep=0 joints=0,", "joints: '0,', expected numbers with commas between"},
      {head + " robot=arm tick=1 macrostep=0 joints=0,nan", "joints: '0,nan', expected finite numbers"},
      {head + " robot=arm tick=1 macrostep=0 joints=0 pose=0,0,0,1,0,0", "pose: '0,0,0,1,0,0', expected 7 numbers"},
      {head + " robot=arm tick=1 macrostep=0 joints=0 pose=0,0,0,2,0,0,0", "expected a quaternion of length 1"},
      {head + state.substr(0, state.size() - 1) + "0,0", "desired: '0,0', expected 1 numbers"},
      {head + robot + " wrench=1,2", "wrench: '1,2', expected 6 numbers"},
      {head + robot + " error=\"minor error: none\"", "error: 'minor', expected one of non-fatal, hardware, system"},
      {head + robot + " command=jump,N10,v8", "command: 'jump', expected one of query, hold, joint"},
      {head + robot + " command=hold,10,v8", "command: '10', expected N and a number"},
      {head + robot + " command=hold,N10", "command: '', expected v and a number"},
      {head + robot + " command=hold,N10,v8:1", "expected no target"},
      {head + robot + " command=joint,N10,v8", "expected a target"},
      {head + robot + " command=pose,N10,v8:1,2,3", "expected 7 numbers behind the colon"},
      {head + robot + " command=twist,N10,v8:1,2,3", "expected 6 numbers behind the colon"},
      {head + robot + " command=force,N10,v8:0,0,0,0,0,0,uuu,0,0,0,0,0,0", "expected 6 velocities, 6 letters"},
      {head + robot + " command=hold,N10,v8,late5", "command: 'late5', expected start and a number"},
      {head + " sensor=gate values=1", "sensor: ' values=1', expected ' tick='"},
      {head + " sensor=gate tick=1 values=1;2", "values: '1;2', expected numbers"},
      {head + " sensor=gate tick=1 values=1 period=0", "period: '0', expected at least 1"},
      {head + " condition=\"gate\"", "condition: 'gate\"', expected a text with '\":0'"},
      {head + " end=bored", "end: 'bored', expected one of condition, generator"},
      {head + " end=condition skew=-1", "skew: '-1'"},
      {head + " end=condition robot=arm", "behind the last field: 'robot=arm', expected the end of the line"},
  };
  for (const auto& [text, expected] : cases)
    EXPECT_NE(message_of(text).find(expected), std::string::npos) << text << "\n"
                                                                  << message_of(text) << "\n"
                                                                  << expected;
}

TEST(ParseLine, AnyChangeOfOneCharacterIsReadOrRefused) {
  const TraceText trace = example_trace();
  fakes::check_property(5000, [&trace] {
    const std::size_t i = *rc::gen::inRange<std::size_t>(0, trace.items.size());
    if (!trace.is_line(i)) return;
    std::string text = format_line(trace.line(i));
    text[*rc::gen::inRange<std::size_t>(0, text.size())] = *rc::gen::inRange(' ', '~');
    try {
      parse_line(text, kLongest);
    } catch (const Malformed&) {
    }
  });
}

TEST(ParseLine, ReadsTheBeginningOfACutLine) {
  const std::string text = format_line(example_trace().line(5)).substr(0, 200);
  const Line line = parse_line(text, 200);
  EXPECT_TRUE(line.cut);
  EXPECT_EQ(line.name, "JointLine");
  EXPECT_EQ(line.step, 1U);
  EXPECT_TRUE(line.robots.empty());
}

}  // namespace
}  // namespace mrroc::cli::trace::parse_line_test
