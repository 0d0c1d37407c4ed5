#include "drivers/socketcan/io_pdos.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrroc::edp {

namespace {

using namespace canopen;

constexpr int kBlock = 8;        // digital terminals in one byte
constexpr int kAnalogInPdo = 4;  // values of 16 bits
constexpr double kEnd = 32767;   // counts

Object part(std::uint16_t index, int place) { return {index, static_cast<std::uint8_t>(place + 1)}; }

/// Index, from 0, of the first analogue value in PDO `number`, and the number of values in it.
struct AnalogPart {
  int first, count;
  AnalogPart(int number, int terminals)
      : first((number - 2) * kAnalogInPdo), count(std::clamp(terminals - first, 0, kAnalogInPdo)) {}
};

std::array<PdoMapping, IoPdos::kCount> mappings(std::uint16_t digital, int digital_count, std::uint16_t analog,
                                                int analog_count) {
  std::array<PdoMapping, IoPdos::kCount> maps;
  std::vector<MappedObject> blocks;
  for (int i = 0; i * kBlock < digital_count; ++i) blocks.push_back({part(digital, i), 1});
  maps[0] = PdoMapping(blocks);
  for (int number = 2; number <= IoPdos::kCount; ++number) {
    const AnalogPart values(number, analog_count);
    std::vector<MappedObject> objects;
    objects.reserve(kAnalogInPdo);
    for (int i = 0; i < values.count; ++i) objects.push_back({part(analog, values.first + i), 2});
    maps[static_cast<std::size_t>(number - 1)] = PdoMapping(objects);
  }
  return maps;
}

std::size_t terminal(const config::TerminalRange& range, int place) noexcept {
  return static_cast<std::size_t>(range.first) + static_cast<std::size_t>(place);
}

/// A part of the range as counts; a value beyond it becomes its end, a value that is not finite 0.
std::int64_t counts_of(double part_of_range) noexcept {
  constexpr double kLeast = std::numeric_limits<std::int16_t>::min();
  return std::isfinite(part_of_range) ? std::llround(std::clamp(part_of_range * kEnd, kLeast, kEnd)) : 0;
}

bool read_digital(const can::Frame& frame, const PdoMapping& mapping, std::uint16_t object,
                  const config::TerminalRange& range, ControllerIo& io) noexcept {
  if (frame.fd || frame.size < mapping.size()) return false;
  for (int i = 0; i < range.count; ++i) {
    std::int64_t block = 0;
    if (!mapping.read(frame, part(object, i / kBlock), false, block)) return false;
    io.set(range.first + i, (block >> (i % kBlock) & 1) != 0);
  }
  return true;
}

bool read_analog(const can::Frame& frame, int number, const PdoMapping& mapping, std::uint16_t object,
                 const config::AnalogTerminals& range, ControllerIo& io) noexcept {
  if (frame.fd || frame.size < mapping.size()) return false;
  const AnalogPart values(number, range.count);
  for (int i = values.first; i < values.first + values.count; ++i) {
    std::int64_t counts = 0;
    if (!mapping.read(frame, part(object, i), true, counts)) return false;
    io.analog[terminal(range, i)] = static_cast<double>(counts) / kEnd * range.range;
  }
  return true;
}

}  // namespace

IoPdos::IoPdos(const config::IoEntry& entry)
    : node_(entry.node),
      digital_inputs_(entry.digital_inputs),
      digital_outputs_(entry.digital_outputs),
      analog_inputs_(entry.analog_inputs),
      analog_outputs_(entry.analog_outputs),
      transmit_(mappings(kReadInputs, entry.digital_inputs.count, kReadAnalogInputs, entry.analog_inputs.count)),
      receive_(mappings(kWriteOutputs, entry.digital_outputs.count, kWriteAnalogOutputs, entry.analog_outputs.count)) {}

bool IoPdos::read(const can::Frame& frame, int number, ControllerIo& inputs) const noexcept {
  if (number == 1) return read_digital(frame, transmit(1), kReadInputs, digital_inputs_, inputs);
  return read_analog(frame, number, transmit(number), kReadAnalogInputs, analog_inputs_, inputs);
}

bool IoPdos::read_outputs(const can::Frame& frame, int number, ControllerIo& outputs) const noexcept {
  if (number == 1) return read_digital(frame, receive(1), kWriteOutputs, digital_outputs_, outputs);
  return read_analog(frame, number, receive(number), kWriteAnalogOutputs, analog_outputs_, outputs);
}

can::Frame IoPdos::write(int number, const ControllerIo& outputs) const noexcept {
  can::Frame frame{kReceivePdo1 + 0x100u * static_cast<std::uint32_t>(number - 1) + node_, {}};
  if (number == 1) {
    std::array<std::int64_t, ControllerIo::kDigital / kBlock> blocks{};
    for (int i = 0; i < digital_outputs_.count; ++i)
      if (outputs.on(digital_outputs_.first + i)) blocks[static_cast<std::size_t>(i / kBlock)] |= 1 << i % kBlock;
    for (std::size_t i = 0; i < blocks.size(); ++i)
      receive(1).write(frame, part(kWriteOutputs, static_cast<int>(i)), blocks[i]);
    return frame;
  }
  const AnalogPart values(number, analog_outputs_.count);
  for (int i = values.first; i < values.first + values.count; ++i) {
    receive(number).write(frame, part(kWriteAnalogOutputs, i),
                          counts_of(outputs.analog[terminal(analog_outputs_, i)] / analog_outputs_.range));
  }
  return frame;
}

void IoPdos::copy_inputs(const ControllerIo& from, ControllerIo& to) const noexcept {
  for (int i = 0; i < digital_inputs_.count; ++i) to.set(digital_inputs_.first + i, from.on(digital_inputs_.first + i));
  for (int i = 0; i < analog_inputs_.count; ++i)
    to.analog[terminal(analog_inputs_, i)] = from.analog[terminal(analog_inputs_, i)];
}

}  // namespace mrroc::edp
