#include "drivers/socketcan/io_pdos.hpp"

#include <gtest/gtest.h>

#include "canopen/random_frames.hpp"
#include "io_rig.hpp"

namespace mrroc::edp {
namespace {

using namespace canopen;

config::IoEntry random_entry() {
  config::IoEntry entry;
  entry.node = *rc::gen::inRange<NodeId>(1, kMaxNode + 1);
  const auto terminals = [](int most) {
    const int count = *rc::gen::inRange(0, most + 1);
    return config::TerminalRange{*rc::gen::inRange(0, most - count + 1), count};
  };
  const auto range = [] { return *rc::gen::inRange(1, 100) * 0.5; };
  entry.digital_inputs = terminals(ControllerIo::kDigital);
  entry.digital_outputs = terminals(ControllerIo::kDigital);
  entry.analog_inputs = {terminals(ControllerIo::kAnalog), range()};
  entry.analog_outputs = {terminals(ControllerIo::kAnalog), range()};
  return entry;
}

ControllerIo random_io(double range) {
  ControllerIo io;
  io.digital = *rc::gen::arbitrary<std::uint16_t>();
  for (double& value : io.analog) value = *rc::gen::inRange(-1000, 1001) / 1000.0 * range;
  return io;
}

/// The same data as if the node's inputs were its outputs.
can::Frame returned(can::Frame frame, int number, NodeId node) {
  frame.id = kTransmitPdo1 + 0x100u * static_cast<std::uint32_t>(number - 1) + node;
  return frame;
}

TEST(IoPdos, OutputsThatReturnAsInputsAreEqual) {
  EXPECT_TRUE(rc::check("every terminal, within half a count", [] {
    config::IoEntry entry = random_entry();
    entry.digital_inputs = entry.digital_outputs;
    entry.analog_inputs = entry.analog_outputs;
    const IoPdos pdos(entry);
    const ControllerIo outputs = random_io(entry.analog_outputs.range);
    const ControllerIo before = random_io(1);
    ControllerIo inputs = before;
    for (int number = 1; number <= IoPdos::kCount; ++number)
      RC_ASSERT(pdos.read(returned(pdos.write(number, outputs), number, entry.node), number, inputs));
    const auto has = [](const config::TerminalRange& range, int i) {
      return i >= range.first && i < range.first + range.count;
    };
    for (int i = 0; i < ControllerIo::kDigital; ++i)
      RC_ASSERT(inputs.on(i) == (has(entry.digital_outputs, i) ? outputs : before).on(i));
    for (int i = 0; i < ControllerIo::kAnalog; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const bool own = has(entry.analog_outputs, i);
      const double error = std::abs(inputs.analog[k] - (own ? outputs : before).analog[k]);
      RC_ASSERT(error <= (own ? 0.5001 * entry.analog_outputs.range / 32767 : 0));
    }
  }));
}

TEST(IoPdos, ShortFramesAreNoAnswer) {
  EXPECT_TRUE(rc::check("any frame", [](can::Frame frame) {
    const config::IoEntry entry = random_entry();
    const IoPdos pdos(entry);
    const int number = *rc::gen::inRange(1, IoPdos::kCount + 1);
    const ControllerIo before = random_io(1);
    ControllerIo inputs = before;
    const bool whole = !frame.fd && frame.size >= pdos.transmit(number).size();
    RC_ASSERT(pdos.read(frame, number, inputs) == whole);
    if (!whole) RC_ASSERT(inputs == before);
    for (const double value : inputs.analog) RC_ASSERT(std::isfinite(value));
  }));
}

TEST(IoPdos, AnalogueOutputsEndWithTheirRange) {
  const config::IoEntry entry = io_table().nodes[0];
  const IoPdos pdos(entry);
  ControllerIo outputs;
  for (const auto& [value, counts] : std::vector<std::pair<double, int>>{
           {10, 32767}, {12, 32767}, {-10, -32767}, {-1e300, -32768}, {5, 16384}, {std::nan(""), 0}, {INFINITY, 0}}) {
    outputs.analog[0] = value;
    EXPECT_EQ(can::sign_extended(can::get(pdos.write(2, outputs).bytes(), 0, 2), 2), counts) << value;
  }
}

TEST(IoPdos, AreThoseOfTheProfile) {
  const IoPdos pdos(io_table().nodes[0]);
  ControllerIo outputs;
  outputs.digital = 0xfa5;
  EXPECT_EQ(pdos.write(1, outputs), (can::Frame{0x228, {0xa5, 0x0f}}));
  EXPECT_EQ(pdos.write(2, outputs), (can::Frame{0x328, {0, 0, 0, 0}}));
  EXPECT_EQ(pdos.receive(3).size(), 0u) << "two analogue outputs";
  EXPECT_EQ(pdos.transmit(1).objects().at(1), (MappedObject{{0x6000, 2}, 1}));
  EXPECT_EQ(pdos.transmit(2).objects().at(3), (MappedObject{{0x6401, 4}, 2}));
  EXPECT_EQ(pdos.transmit(3).objects().at(0), (MappedObject{{0x6401, 5}, 2}));
}

}  // namespace
}  // namespace mrroc::edp
