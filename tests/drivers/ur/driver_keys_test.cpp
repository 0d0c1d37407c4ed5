#include "drivers/ur/driver_keys.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "config/table.hpp"

namespace mrroc::ur::driver_keys_test {
namespace {

TEST(DriverKeys, DefaultsAreThoseOfTheOptions) {
  const auto file = config::Table::load(MRROC_SOURCE_DIR "/drivers/ur/ur.toml");
  std::map<std::string, std::vector<double>> numbers;
  std::map<std::string, std::string> texts{{"address", "robot"}};  // the only key without a default
  for (const std::string& key : file.table("parameters").keys()) {
    const config::Table declared = file.table("parameters").table(key);
    if (declared.text("kind") == "text") {
      texts.emplace(key, declared.optional_text("default").value_or("robot"));
    } else if (declared.text("kind") == "numbers") {
      numbers[key] = declared.numbers("default");
    } else {
      numbers[key] = {declared.number("default")};
    }
  }
  const UrOptions options = options_of({numbers, texts}), expected;
  EXPECT_NO_THROW(check(options));
  EXPECT_EQ(options.address, "robot");
  EXPECT_EQ(options.rtde_port, expected.rtde_port);
  EXPECT_EQ(options.dashboard_port, expected.dashboard_port);
  EXPECT_EQ(options.script_port, expected.script_port);
  EXPECT_EQ(options.frequency, expected.frequency);
  EXPECT_EQ(options.timeout, expected.timeout);
  EXPECT_EQ(options.start_timeout, expected.start_timeout);
  EXPECT_EQ(options.missed_max, expected.missed_max);
  EXPECT_EQ(options.registers, expected.registers);
  EXPECT_EQ(options.script, expected.script);
  EXPECT_EQ(options.watchdog, expected.watchdog);
  EXPECT_EQ(options.servo_gain, expected.servo_gain);
  EXPECT_EQ(options.servo_lookahead, expected.servo_lookahead);
  EXPECT_EQ(options.speed_acceleration, expected.speed_acceleration);
  EXPECT_EQ(options.stop_acceleration, expected.stop_acceleration);
  EXPECT_EQ(options.tool_voltage, expected.tool_voltage);
  EXPECT_EQ(options.tool_terminals, expected.tool_terminals);
  EXPECT_EQ(options.speed_slider, expected.speed_slider);
  EXPECT_EQ(options.torque_constants, expected.torque_constants);
}

TEST(DriverKeys, EveryKeyIsDescribed) {
  std::ostringstream page;
  page << std::ifstream(MRROC_SOURCE_DIR "/docs/how-to/ur.md").rdbuf();
  const auto file = config::Table::load(MRROC_SOURCE_DIR "/drivers/ur/ur.toml");
  for (const std::string& key : file.table("parameters").keys())
    EXPECT_NE(page.str().find("`" + key + "`"), std::string::npos) << key;
}

/// A declared key that the driver does not read would be accepted and do nothing.
TEST(DriverKeys, EveryDeclaredKeyIsRead) {
  const auto file = config::Table::load(MRROC_SOURCE_DIR "/drivers/ur/ur.toml");
  const auto declared = file.table("parameters").keys();
  std::map<std::string, std::vector<double>> numbers;
  std::map<std::string, std::string> texts;
  for (const std::string& key : declared) {
    numbers[key] = std::vector<double>(6, 1);
    texts[key] = "text";
  }
  EXPECT_NO_THROW(options_of({numbers, texts}));
  for (const std::string& key : declared) {
    auto fewer = numbers;
    auto fewer_texts = texts;
    fewer.erase(key);
    fewer_texts.erase(key);
    EXPECT_THROW(options_of({fewer, fewer_texts}), std::out_of_range) << key;
  }
}

}  // namespace
}  // namespace mrroc::ur::driver_keys_test
