#include "vsp/simulated_source.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "mrroc/errors.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "vsp/fakes.hpp"
#include "vsp/make_source.hpp"
#include "world/mapped_world.hpp"

namespace mrroc::vsp::simulated_source_test {
namespace {

RawReading hardware_reading(Tick tick, std::vector<double> values) {
  RawReading reading;
  reading.tick = tick;
  reading.count = static_cast<std::uint32_t>(values.size());
  std::copy(values.begin(), values.end(), reading.values.begin());
  return reading;
}

TEST(SimulatedSource, ReadsTheNewestReadingOfItsSlotFromSharedMemory) {
  const world::MappedWorld world = world::MappedWorld::create();
  const world::MappedWorld mine = world::MappedWorld::attach(world.fd());
  SimulatedSource source(*mine, 3, 50);
  world->readings[2].store(hardware_reading(7, {99}));
  world->readings[3].store(hardware_reading(7, {1.5, -2.5}));
  RawReading raw;
  ASSERT_EQ(source.read(7, raw), SourceState::ready);
  EXPECT_EQ(raw.tick, 7U);
  ASSERT_EQ(raw.count, 2U);
  EXPECT_EQ(raw.values[0], 1.5);
  EXPECT_EQ(raw.values[1], -2.5);
  world->readings[3].store(hardware_reading(8, {3.5, 0}));
  ASSERT_EQ(source.read(7, raw), SourceState::ready);  // ahead of the requested tick: its own tick
  EXPECT_EQ(raw.tick, 8U);
  EXPECT_EQ(raw.values[0], 3.5);
}

TEST(SimulatedSource, IsNotReadyBeforeTheFirstReadingThenSilent) {
  const auto world = std::make_unique<world::WorldMemory>();
  SimulatedSource source(*world, 0, 50);
  RawReading raw;
  EXPECT_EQ(source.read(0, raw), SourceState::not_ready);
  EXPECT_EQ(source.read(50, raw), SourceState::not_ready);
  EXPECT_EQ(source.read(51, raw), SourceState::silent);
}

TEST(SimulatedSource, IsSilentWhenReadingsStopAndReadyWhenTheyReturn) {
  const auto world = std::make_unique<world::WorldMemory>();
  SimulatedSource source(*world, 0, 50);
  RawReading raw;
  world->readings[0].store(hardware_reading(100, {1}));
  EXPECT_EQ(source.read(150, raw), SourceState::ready);
  EXPECT_EQ(raw.tick, 100U);
  EXPECT_EQ(source.read(151, raw), SourceState::silent);
  world->readings[0].store(hardware_reading(151, {2}));
  EXPECT_EQ(source.read(151, raw), SourceState::ready);
}

TEST(SimulatedSource, RefusesAnUnknownSlot) {
  const auto world = std::make_unique<world::WorldMemory>();
  EXPECT_THROW(SimulatedSource(*world, world::kMaxSensors, 50), SystemError);
}

TEST(MakeSource, SelectsTheSourceOfTheDeployment) {
  const auto world = std::make_unique<world::WorldMemory>();
  world->readings[1].store(hardware_reading(0, {4}));
  config::SensorEntry entry;
  entry.name = "gate";
  FakeSensor sensor;
  RawReading raw;

  const config::Deployment deployment;
  const auto simulated = make_source(sensor, {deployment, entry, 1, world.get(), 0.002});
  EXPECT_EQ(simulated->read(50, raw), SourceState::ready);
  EXPECT_EQ(raw.values[0], 4);
  EXPECT_EQ(simulated->read(1501, raw), SourceState::silent);  // 3 s at 2 ms

  const task_test::ScratchFolder scratch;
  entry.source = "replay";
  entry.replay = scratch.write("played.txt", "# mrroc readings in\n0 5\n");
  ASSERT_EQ(make_source(sensor, {deployment, entry, 0, nullptr, 0.002})->read(0, raw), SourceState::ready);
  EXPECT_EQ(raw.values[0], 5);
}

TEST(MakeSource, RefusesASimulatedSensorWithoutAWorld) {
  config::SensorEntry entry;
  entry.name = "gate";
  FakeSensor sensor;
  const config::Deployment deployment;
  EXPECT_THROW(make_source(sensor, {deployment, entry, 0, nullptr, 0.002}), SystemError);
  entry.source = "hardware";
  EXPECT_THROW(make_source(sensor, {deployment, entry, 0, nullptr, 0.002}), SystemError);
}

}  // namespace
}  // namespace mrroc::vsp::simulated_source_test
