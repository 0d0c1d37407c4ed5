#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "config/table.hpp"
#include "drivers/netft/netft_rig.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::netft::netft_options_test {
namespace {

/// A table [sensors.wrist.netft] with the defaults of netft.toml.
class Keys {
 public:
  Keys() {
    entry_.name = "wrist";
    entry_.type = "force_torque";
    const auto declared = config::Table::load(MRROC_SOURCE_DIR "/drivers/netft/netft.toml").table("parameters");
    for (const std::string& key : declared.table_names()) {
      const config::Table each = declared.table(key);
      if (!each.has("default")) continue;
      if (each.text("kind") == "text") {
        texts[key] = each.text("default");
      } else {
        numbers[key] = {each.number("default")};
      }
    }
    texts["address"] = "192.168.1.1";
  }
  NetftOptions options() const { return netft_options(entry_, {numbers, texts}); }
  std::string refusal() const {
    try {
      options();
      return "";
    } catch (const SystemError& error) {
      EXPECT_EQ(error.code(), ErrorCode::configuration);
      return error.detail();
    }
  }

  std::map<std::string, std::vector<double>> numbers;
  std::map<std::string, std::string> texts;

 private:
  config::SensorEntry entry_;
};

TEST(NetftOptions, DefaultsOfTheDeclarationsAreThoseOfTheCode) {
  const NetftOptions options = Keys().options(), defaults;
  EXPECT_EQ(options.address, "192.168.1.1");
  EXPECT_EQ(options.port, defaults.port);
  EXPECT_EQ(options.http_port, defaults.http_port);
  EXPECT_FALSE(options.calibration);
  EXPECT_EQ(options.timeout, defaults.timeout);
  EXPECT_EQ(options.start_timeout, defaults.start_timeout);
  EXPECT_EQ(options.rate_min, defaults.rate_min);
  EXPECT_EQ(options.requests, defaults.requests);
  EXPECT_EQ(options.set_bias, defaults.set_bias);
}

TEST(NetftOptions, CountsNeedBothFactors) {
  Keys keys;
  keys.numbers["counts_per_force"] = {1000};
  EXPECT_EQ(keys.refusal(),
            "sensors.wrist.netft.counts_per_torque: 0, expected a number above 0 beside counts_per_force");
  keys.numbers["counts_per_torque"] = {500};
  keys.texts["torque_unit"] = "N-mm";
  const auto calibration = keys.options().calibration;
  ASSERT_TRUE(calibration);
  EXPECT_DOUBLE_EQ(calibration->newtons_per_count, 0.001);
  EXPECT_DOUBLE_EQ(calibration->newton_metres_per_count, 2e-6);
  keys.texts["force_unit"] = "stone";
  EXPECT_EQ(keys.refusal(), "sensors.wrist.netft.force_unit: 'stone', expected N, kN, lbf, klbf, kgf or gf");
}

TEST(NetftOptions, WrongValuesAreRefusedWithTheirKey) {
  Keys keys;
  keys.numbers["port"] = {1.5};
  EXPECT_EQ(keys.refusal(), "sensors.wrist.netft.port: 1.5, expected a whole number from 1 to 65535");
  keys = Keys();
  keys.texts["requests"] = "often";
  EXPECT_EQ(keys.refusal(), "sensors.wrist.netft.requests: 'often', expected 'automatic', 'stream' or 'polled'");
  keys = Keys();
  keys.texts["sensor_bias"] = "yes";
  EXPECT_EQ(keys.refusal(), "sensors.wrist.netft.sensor_bias: 'yes', expected 'keep' or 'set'");
  keys = Keys();
  keys.texts.erase("address");
  EXPECT_EQ(keys.refusal(), "sensors.wrist.netft.address: missing, expected a text");
}

/// A deployment with one sensor.
class OpenNetft : public testing::Test {
 protected:
  OpenNetft() {
    entry_.name = "wrist";
    entry_.type = "force_torque";
  }
  std::unique_ptr<vsp::Source> open(clock::Clock* clock) {
    return open_netft(rig_.options(), {deployment_, entry_, 0, nullptr, kServoPeriod, clock});
  }
  std::string refusal(clock::Clock* clock) {
    try {
      open(clock);
      return "";
    } catch (const SystemError& error) {
      return error.detail();
    }
  }

  Rig rig_;
  config::Deployment deployment_;
  config::SensorEntry entry_;
  links::TestClock real_, simulated_{true};
};

TEST_F(OpenNetft, NeedsTheRealClock) {
  EXPECT_EQ(refusal(&simulated_),
            "sensors.wrist.source: 'netft' with simulated time, expected clock = \"real\" in [deployment]");
  EXPECT_NE(refusal(nullptr), "");
  EXPECT_EQ(refusal(&real_), "");
}

TEST_F(OpenNetft, RefusesGaugesAndOtherTypes) {
  entry_.numbers["calibration"] = std::vector<double>(36, 0.0);
  EXPECT_EQ(refusal(&real_), "");
  entry_.numbers["calibration"][7] = 1;
  EXPECT_NE(refusal(&real_).find("sensors.wrist.calibration: a matrix for gauge voltages"), std::string::npos);
  entry_.numbers.clear();
  entry_.type = "infrared";
  EXPECT_EQ(refusal(&real_), "sensors.wrist.source: 'netft' for the type 'infrared', expected 'force_torque'");
}

TEST_F(OpenNetft, ReportsDisturbedRecordsAtItsEnd) {
  EXPECT_EQ(disturbances({.records = 7000}), "");
  EXPECT_EQ(disturbances({.records = 7000, .lost = 3, .late = 1, .sensor_restarts = 2}),
            "of 7000 records 3 lost, 1 late, 2 restarts of the sensor");
  auto source = open(&real_);
  const auto requests = rig_.server().requests();
  rig_.server().set_faults({.frozen = true});
  EXPECT_TRUE(eventually([&] { return rig_.server().requests() > requests; })) << "it has become silent";
  testing::internal::CaptureStderr();
  source.reset();
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(text.starts_with("Net F/T of sensor wrist: of ")) << text;
  EXPECT_NE(text.find(" without a new measurement"), std::string::npos) << text;
}

TEST_F(OpenNetft, SensorOfARobotIsPolled) {
  const auto stream = open(&real_);
  EXPECT_TRUE(eventually([&] { return rig_.server().clients() == 1; }));
  deployment_.robots.emplace_back();
  deployment_.robots.back().force_sensor = "wrist";
  const auto requests = rig_.server().requests();
  const auto polled = open(&real_);
  EXPECT_TRUE(eventually([&] { return rig_.server().requests() > requests + 20; }));
}

}  // namespace
}  // namespace mrroc::netft::netft_options_test
