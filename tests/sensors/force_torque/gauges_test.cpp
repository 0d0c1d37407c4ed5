#include "sensors/force_torque/gauges.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "mrroc/errors.hpp"
#include "sensors/force_torque/made_sensor.hpp"
#include "sensors/force_torque/simulated_gauges.hpp"

namespace mrroc::vsp::gauges_test {
namespace {

/// A calibration of the usual pattern of three beams.
constexpr const char* kCalibration = R"(calibration = [
  -0.41,  0.18,  1.12, -33.52, -0.94,  33.81,
  -1.23, 39.47,  0.61, -19.18,  0.79, -19.63,
  63.05, -0.72, 64.02,   1.24, 62.51,  -1.37,
  -0.02,  0.49,  1.78,  -0.27, -1.80,  -0.22,
  -2.05,  0.02,  1.03,   0.40,  1.01,  -0.44,
   0.01,  1.02, -0.03,   1.01,  0.02,   1.03,
]
gauge_zero = [0.12, -0.35, 0.08, 0.21, -0.17, 0.05]
)";
const GaugeVoltages kZero{{0.12, -0.35, 0.08, 0.21, -0.17, 0.05}};

Wrench any_load() {
  Wrench load;
  for (int i = 0; i < 6; ++i) load[i] = *rc::gen::inRange(-1000, 1001) * (i < 3 ? 0.05 : 0.005);
  return load;
}

RawReading raw_of_gauges(const GaugeVoltages& voltages, Tick tick = 0) { return raw_of(-voltages, tick); }

/// A source with constant readings.
class OneReading final : public Source {
 public:
  OneReading(const RawReading& raw, SourceState state) : raw_(raw), state_(state) {}
  SourceState read(Tick /*wanted*/, RawReading& raw) noexcept override {
    raw = raw_;
    return state_;
  }

 private:
  RawReading raw_;
  SourceState state_;
};

std::string refusal(const std::string& toml) {
  try {
    made_sensor(toml);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "none";
}

std::string with_row(const std::string& row) {
  return "calibration = [1.0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0,\n0, 0, 0, 1, 0, 0,\n" + row +
         ",\n0, 0, 0, 0, 0, 1]\n";
}

TEST(Gauges, ForceIsTheMatrixTimesTheVoltagesWithoutTheirZero) {
  ForceTorqueSensor sensor = made_sensor(kCalibration);
  EXPECT_EQ(wrench_of(aggregated(sensor, raw_of_gauges(kZero))), Wrench::Zero());
  // a column of the matrix, calculated by hand: 1 V more at gauge 3
  const Wrench column{{-33.52, -19.18, 1.24, -0.27, 0.40, 1.01}};
  GaugeVoltages voltages = kZero;
  voltages[3] += 1;
  EXPECT_LT((wrench_of(aggregated(sensor, raw_of_gauges(voltages))) - column).norm(), 1e-12);
}

TEST(Gauges, RawChannelsAreVoltagesOnlyWithACalibration) {
  EXPECT_EQ(made_sensor().raw_channels()[0].name, "support_force_x");
  const auto channels = made_sensor(kCalibration).raw_channels();
  ASSERT_EQ(channels.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(channels[i].name, std::string("gauge_").append(std::to_string(i)));
    EXPECT_EQ(channels[i].unit, "V");
  }
}

TEST(Gauges, SimulatedGaugesReproduceTheLoad) {
  EXPECT_TRUE(rc::check([] {
    ForceTorqueSensor sensor = made_sensor(kCalibration);
    const Wrench load = any_load();
    SimulatedGauges source{*Gauges::of(entry_of("force_torque", "wrist", kCalibration)),
                           std::make_unique<OneReading>(raw_of(load), SourceState::ready)};
    RawReading r;
    RC_ASSERT(source.read(0, r) == SourceState::ready);
    const SensorReading v = aggregated(sensor, r);
    RC_ASSERT(v.error.error_class == ErrorClass::none);
    RC_ASSERT((wrench_of(v) - load).norm() < 1e-10);
  }));
}

TEST(Gauges, SimulatedGaugesPassInvalidWrenchesOn) {
  const Gauges gauges = *Gauges::of(entry_of("force_torque", "wrist", kCalibration));
  RawReading broken = raw_of(Wrench::Zero());
  broken.values[2] = std::numeric_limits<double>::quiet_NaN();
  RawReading r;
  SimulatedGauges failing{gauges, std::make_unique<OneReading>(broken, SourceState::ready)};
  EXPECT_EQ(failing.read(0, r), SourceState::ready);
  EXPECT_TRUE(std::isnan(r.values[2]));
  SimulatedGauges silent{gauges, std::make_unique<OneReading>(broken, SourceState::silent)};
  EXPECT_EQ(silent.read(0, r), SourceState::silent);
}

TEST(Gauges, SaturatedGaugeIsAnErrorWithoutAValue) {
  const std::string toml = std::string(kCalibration) + "gauge_limit = 5.0\nforce_range = [1e9, 1e9, 1e9]\n";
  for (int gauge = 0; gauge < 6; ++gauge) {
    for (const double volts : {5.0, -5.0, 7.5}) {
      ForceTorqueSensor sensor = made_sensor(toml + "torque_range = [1e9, 1e9, 1e9]");
      GaugeVoltages voltages = kZero;
      const Wrench before = wrench_of(aggregated(sensor, raw_of_gauges(voltages, 1)));
      voltages[gauge] = volts;
      const SensorReading v = aggregated(sensor, raw_of_gauges(voltages, 2));
      EXPECT_EQ(v.error.error_class, ErrorClass::non_fatal);
      EXPECT_EQ(v.error.code, ErrorCode::sensor_out_of_range);
      for (std::size_t i = 0; i < 6; ++i) EXPECT_TRUE(std::isnan(v.values[i]));
      EXPECT_EQ(wrench_of(aggregated(sensor, raw_of_gauges(kZero, 3))), before);
      voltages[gauge] = std::nextafter(volts, 0) * (5.0 / std::abs(volts));
      EXPECT_EQ(aggregated(sensor, raw_of_gauges(voltages, 4)).error.error_class, ErrorClass::none);
    }
  }
}

TEST(Gauges, ErrorNamesGaugeVoltageAndLimit) {
  ForceTorqueSensor sensor = made_sensor(kCalibration);
  GaugeVoltages voltages = kZero;
  voltages[4] = -10;
  EXPECT_EQ(aggregated(sensor, raw_of_gauges(voltages)).error.detail.view(),
            "gauge 4 is saturated at -10 V, expected less than 10");
}

TEST(Gauges, OverloadOfTheSimulatedWristSaturatesThem) {
  const config::SensorEntry entry = entry_of("force_torque", "wrist", kCalibration);
  ForceTorqueSensor sensor = made_sensor(kCalibration);
  RawReading r;
  SimulatedGauges source{*Gauges::of(entry),
                         std::make_unique<OneReading>(raw_of(Wrench{{0, 0, 5000, 0, 0, 0}}), SourceState::ready)};
  source.read(0, r);
  EXPECT_EQ(aggregated(sensor, r).error.code, ErrorCode::sensor_out_of_range);
}

TEST(Gauges, RefusesAnInvalidMatrix) {
  EXPECT_EQ(refusal(with_row("0, 0, 0, 0, 1, 0")), "none");
  for (const char* row : {"0, 0, 0, 0, 0, 0", "0, 0, 0, 1, 0, 0", "0, 0, 0, -50, 1e-7, 0"}) {
    EXPECT_NE(refusal(with_row(row)).find("sensors.wrist.calibration: a matrix that cannot be inverted, expected 6"),
              std::string::npos)
        << row << ": " << refusal(with_row(row));
  }
  // errors of the file: line and index in the array
  EXPECT_NE(refusal(with_row("0, 0, 0, 0, 1")).find("sensor.toml:1: calibration: has 35 values"), std::string::npos);
  EXPECT_NE(refusal(with_row("0, 0, 0, 0, nan, 0")).find("sensor.toml:3: calibration[28]"), std::string::npos)
      << refusal(with_row("0, 0, 0, 0, nan, 0"));
  EXPECT_NE(refusal(with_row("0, 0, 0, 0, 1, 0") + "gauge_zero = [0, 0, 0, 0, 11, 0]").find("gauge_zero[4]: 11"),
            std::string::npos);
}

}  // namespace
}  // namespace mrroc::vsp::gauges_test
