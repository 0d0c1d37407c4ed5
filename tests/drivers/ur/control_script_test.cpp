#include "drivers/ur/control_script.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mrroc::ur::control_script_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

UrOptions options() {
  UrOptions options;
  options.address = "127.0.0.1";
  options.script = MRROC_SOURCE_DIR "/drivers/ur/control.script";
  return options;
}

TEST(ControlScript, EveryWordIsReplaced) {
  UrOptions changed = options();
  changed.registers = 7;
  changed.watchdog = 0.1;
  changed.payload_mass = 1.25;
  changed.payload_centre = {0.01, 0, 0.05};
  changed.servo_lookahead = 0.03;
  const std::string program = control_program(read_control_script(changed), changed, 500, 42);
  EXPECT_THAT(program, StartsWith("def mrroc_control():\n  # mrroc_control 1\n"));
  EXPECT_THAT(program, Not(HasSubstr("@")));
  EXPECT_THAT(program, HasSubstr("set_payload(1.25, [0.01, 0, 0.05])"));
  EXPECT_THAT(program, Not(HasSubstr("set_tool_voltage")));
  EXPECT_THAT(program, HasSubstr("read_input_float_register(7)"));
  EXPECT_THAT(program, HasSubstr("read_input_float_register(18)"));
  EXPECT_THAT(program, HasSubstr("write_output_integer_register(9, 42)"));
  EXPECT_THAT(program, HasSubstr("silent > 50:"));
  EXPECT_THAT(program, HasSubstr("lookahead_time=0.03, gain=300"));
  EXPECT_TRUE(program.ends_with("\nend\n"));
}

// 0 kg would be wrong for every tool
TEST(ControlScript, PayloadOfTheTeachPendantStaysWithoutALoad) {
  EXPECT_THAT(control_program(read_control_script(options()), options(), 500, 1), Not(HasSubstr("set_payload")));
}

TEST(ControlScript, TheWatchdogIsATimeInEveryFrequency) {
  const std::string script = read_control_script(options());
  EXPECT_THAT(control_program(script, options(), 125, 1), HasSubstr("silent > 13:"));
}

TEST(ControlScript, EveryBlockEnds) {
  const std::string program = control_program(read_control_script(options()), options(), 500, 1);
  std::istringstream lines(program);
  std::string line;
  int depth = 0;
  while (std::getline(lines, line)) {
    const std::size_t begin = line.find_first_not_of(' ');
    ASSERT_NE(begin, std::string::npos);
    const std::string code = line.substr(begin);
    const bool closes = code == "end", continues = code.starts_with("el");
    const bool opens = code.ends_with(":") && !continues;
    if (closes) --depth;
    // two columns for each block
    EXPECT_EQ(begin, 2 * static_cast<std::size_t>(continues ? depth - 1 : depth)) << line;
    if (opens) ++depth;
  }
  EXPECT_EQ(depth, 0);
}

TEST(ControlScript, ErrorsNameTheFileOrTheWord) {
  UrOptions missing = options();
  missing.script = "/nowhere/control.script";
  EXPECT_THROW(read_control_script(missing), std::runtime_error);
  missing.script = MRROC_SOURCE_DIR "/README.md";
  EXPECT_THROW(read_control_script(missing), std::runtime_error);
  std::string text;
  try {
    control_program("def a():\n  b(@WRONG@)\nend\n", options(), 500, 1);
  } catch (const std::runtime_error& error) {
    text = error.what();
  }
  EXPECT_THAT(text, HasSubstr("@WRONG@"));
  EXPECT_THROW(control_program("def a():\n  b(@)\nend\n", options(), 500, 1), std::runtime_error);
}

TEST(UrOptions, RejectsInvalidValues) {
  const auto rejects = [](auto change) {
    UrOptions changed = options();
    change(changed);
    EXPECT_THROW(check(changed), std::invalid_argument);
  };
  EXPECT_NO_THROW(check(options()));
  rejects([](UrOptions& o) { o.address.clear(); });
  rejects([](UrOptions& o) { o.rtde_port = 0; });
  rejects([](UrOptions& o) { o.script_port = 65536; });
  rejects([](UrOptions& o) { o.frequency = 501; });
  rejects([](UrOptions& o) { o.timeout = std::nan(""); });
  rejects([](UrOptions& o) { o.registers = 37; });
  rejects([](UrOptions& o) { o.servo_lookahead = 0.3; });
  rejects([](UrOptions& o) { o.payload_mass = -1; });
  rejects([](UrOptions& o) { o.tool_voltage = 5; });
  rejects([](UrOptions& o) { o.speed_slider = 1.1; });
}

}  // namespace
}  // namespace mrroc::ur::control_script_test
