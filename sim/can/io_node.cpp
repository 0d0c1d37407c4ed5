#include "sim/can/io_node.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "canopen/emergency.hpp"

namespace mrroc::sim {

using namespace canopen;

namespace {

constexpr Object kCommunicationError{0x1029, 1};      // the reaction: 0 pre-operational, 1 none, 2 stopped
constexpr std::int64_t kStaysAsItIs = 1, kStops = 2;  // its values
constexpr int kPdosToUse = 4;                         // in each direction, at most
constexpr int kBits = 8;                              // of a block
constexpr double kEndOfRange = 32767;
constexpr int kLowBits = 16;  // of an error value of 32 bits, below an output of 16

std::size_t place(int terminal) { return static_cast<std::size_t>(terminal); }

Object part(std::uint16_t index, int number) { return {index, static_cast<std::uint8_t>(number)}; }

}  // namespace

IoNode::IoNode(const config::IoEntry& entry, Send send)
    : entry_(entry),
      send_(std::move(send)),
      store_(std::make_unique<ObjectStore>(entry.eds, entry.node)),
      sdo_(entry.node, *store_) {}

void IoNode::send(const can::Frame& frame) {
  if (!cut_) send_(frame);
}

void IoNode::boot(std::int64_t now) {
  store_->reset();
  restart(now);
}

void IoNode::restart(std::int64_t now) {
  nmt_ = NmtState::pre_operational;
  sdo_.reset();
  store_->lock_mappings(false);
  receive_.clear();
  transmit_.clear();
  alone_ = false;
  heard_ = 0;
  sent_ = now;
  send(heartbeat_frame(node(), NmtState::boot_up));
}

void IoNode::nmt(NmtCommand command, std::int64_t now) {
  switch (command) {
    case NmtCommand::start:
      receive_.clear();
      transmit_.clear();
      for (std::uint16_t i = 0; i < kPdosToUse; ++i) {
        if (auto pdo = configured_pdo(*store_, kReceivePdoParameters + i)) receive_.push_back(*pdo);
        if (auto pdo = configured_pdo(*store_, kTransmitPdoParameters + i)) transmit_.push_back(*pdo);
      }
      nmt_ = NmtState::operational;
      store_->lock_mappings(true);
      syncs_ = 0;
      return;
    case NmtCommand::stop:
      nmt_ = NmtState::stopped;
      return use_error_values();
    case NmtCommand::enter_pre_operational:
      nmt_ = NmtState::pre_operational;
      return store_->lock_mappings(false);
    case NmtCommand::reset_node:
      return boot(now);
    case NmtCommand::reset_communication:
      store_->reset_communication();
      return restart(now);
  }
}

void IoNode::take(const can::Frame& frame, std::int64_t now) {
  if (cut_ || frame.error || frame.remote || frame.fd) return;
  if (frame.id == kNmt && frame.size == 2 && (frame.data[1] == 0 || frame.data[1] == node()))
    return nmt(static_cast<NmtCommand>(frame.data[0]), now);
  if (frame.id == kSdoRequest + node()) {
    if (nmt_ == NmtState::stopped) return;
    if (const auto answer = sdo_.answer(frame)) send(*answer);
    return;
  }
  const auto watched = static_cast<std::uint32_t>(store_->number(kConsumerHeartbeat));
  if (watched != 0 && frame.id == kHeartbeat + (watched >> 16 & 0x7f)) {
    heard_ = now;
    if (std::exchange(alone_, false)) send_emergency(0);
    return;
  }
  if (!operational()) return;
  for (const NodePdo& pdo : receive_)
    if (frame.id == pdo.identifier) pdo.take(frame, *store_);
}

void IoNode::update(std::int64_t now) {
  constexpr std::int64_t kUnit = 1'000'000;  // ns in a ms
  const std::int64_t produced = store_->number(kProducerHeartbeat) * kUnit;
  if (nmt_ != NmtState::boot_up && produced != 0 && now >= sent_ + produced) {
    sent_ = now;
    if (!hushed_) send(heartbeat_frame(node(), nmt_));
  }
  const std::int64_t allowed = (store_->number(kConsumerHeartbeat) & 0xffff) * kUnit;
  if (allowed == 0 || heard_ == 0 || now <= heard_ + allowed) return;
  heard_ = 0;
  lose_master();
}

void IoNode::lose_master() {
  alone_ = true;
  use_error_values();
  send_emergency(kHeartbeatError);
  const std::int64_t reaction = store_->number(kCommunicationError);
  if (!operational() || reaction == kStaysAsItIs) return;
  nmt_ = reaction == kStops ? NmtState::stopped : NmtState::pre_operational;
  store_->lock_mappings(false);
}

void IoNode::fail(std::uint16_t code) {
  if (code != 0) use_error_values();
  send_emergency(code);
}

void IoNode::send_emergency(std::uint16_t code) {
  Emergency emergency;
  emergency.node = node();
  emergency.code = code;
  emergency.error_register = code != 0 ? 1 : 0;
  store_->set(kErrorRegister, emergency.error_register);
  if (nmt_ == NmtState::operational || nmt_ == NmtState::pre_operational) send(to_frame(emergency));
}

/// CiA 401: bits of the mode choose the outputs that take their error values; the others stay.
void IoNode::use_error_values() {
  for (int block = 1; block <= store_->number(part(kWriteOutputs, 0)); ++block) {
    const std::int64_t mode = store_->number(part(kOutputErrorMode, block));
    const std::int64_t value = store_->number(part(kOutputErrorValue, block));
    const Object outputs = part(kWriteOutputs, block);
    store_->set(outputs, (store_->number(outputs) & ~mode) | (value & mode));
  }
  for (int output = 1; output <= store_->number(part(kWriteAnalogOutputs, 0)); ++output)
    if (store_->number(part(kAnalogOutputErrorMode, output)) == 1)
      store_->set(part(kWriteAnalogOutputs, output), store_->number(part(kAnalogOutputErrorValue, output)) >> kLowBits);
}

void IoNode::measure(const ControllerIo& inputs) {
  const config::TerminalRange digital = entry_.digital_inputs;
  for (int block = 0; block * kBits < digital.count; ++block) {
    std::int64_t bits = 0;
    for (int i = block * kBits; i < std::min(digital.count, (block + 1) * kBits); ++i)
      bits |= static_cast<std::int64_t>(inputs.on(digital.first + i)) << i % kBits;
    store_->set(part(kReadInputs, block + 1), bits);
  }
  const config::AnalogTerminals& analog = entry_.analog_inputs;
  for (int i = 0; i < analog.count; ++i) {
    const double value = inputs.analog[place(analog.first + i)] / analog.range * kEndOfRange;
    const double counts = std::isfinite(value) ? std::clamp(value, -kEndOfRange, kEndOfRange) : 0;
    store_->set(part(kReadAnalogInputs, i + 1), std::llround(counts));
  }
}

void IoNode::synchronise() {
  ++syncs_;
  if (!operational()) return;
  for (const NodePdo& pdo : transmit_) {
    if (!pdo.is_due(syncs_)) continue;
    can::Frame frame = pdo.frame(*store_);
    if (shortens_ && frame.size != 0) --frame.size;
    send(frame);
  }
}

void IoNode::drive(ControllerIo& outputs) const {
  const config::TerminalRange digital = entry_.digital_outputs;
  for (int i = 0; i < digital.count; ++i)
    outputs.set(digital.first + i, (store_->number(part(kWriteOutputs, i / kBits + 1)) >> i % kBits & 1) != 0);
  const config::AnalogTerminals& analog = entry_.analog_outputs;
  for (int i = 0; i < analog.count; ++i)
    outputs.analog[place(analog.first + i)] =
        static_cast<double>(store_->number(part(kWriteAnalogOutputs, i + 1))) / kEndOfRange * analog.range;
}

}  // namespace mrroc::sim
