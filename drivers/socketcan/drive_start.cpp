// Prepares a drive for its set-up: no power, no fault, PDOs that may be changed.
#include <array>
#include <cmath>
#include <cstdio>

#include "canopen/emergency.hpp"
#include "clock/wall/monotonic.hpp"
#include "drivers/socketcan/can_hardware.hpp"
#include "drivers/socketcan/repeated_sdo.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::edp {

using namespace canopen;

namespace {

constexpr std::int64_t kBetweenLooks = clock::kSecond / 100;
constexpr std::uint32_t kProfile402 = 402;

}  // namespace

/// Checks the mode: a drive may accept a mode that it does not have, and stay in another.
void CanHardware::check_modes(std::size_t axis, SdoClient& client) const {
  const Object modes = object_of(axis, kSupportedModes);
  if (table_.eds.find(modes) == nullptr) return;
  std::uint64_t supported = 0;
  try {
    supported = can::get(upload_repeated(client, drives_[axis].node(), modes), 0, 4);
  } catch (const SdoError& error) {
    if (error.abort() == SdoAbort::no_such_object) return;  // an EDS file of a family of drives
    throw;
  }
  const bool homes = table_.drives[axis].homing.method != 0 && !synchronised_;
  for (const DriveMode mode : {table_.mode, homes ? DriveMode::homing : table_.mode})
    if ((supported >> (static_cast<int>(mode) - 1) & 1) == 0)
      fail(ErrorCode::configuration, axis,
           "has no mode " + std::string(describe(mode)) + ", expected bit " +
               std::to_string(static_cast<int>(mode) - 1) + " in its supported modes, 6502h, which are " +
               std::to_string(supported));
}

/// The drive's state, a moment after the last check.
DriveState CanHardware::read_state(std::size_t axis, SdoClient& client) {
  send(sync_frame(table_.sync));  // simulated drives may advance only with it
  can::Frame frame;
  const std::int64_t next_look = clock::monotonic_ns() + kBetweenLooks;
  while (clock::monotonic_ns() < next_look && bus_->receive(frame, next_look)) note(frame);
  const auto statusword = upload_repeated(client, drives_[axis].node(), object_of(axis, kStatusword));
  return drive_state(static_cast<std::uint16_t>(can::get(statusword, 0, 2)));
}

/// Its 6007h, or a program of its manufacturer, may have kept it on: it would follow values written now at once.
void CanHardware::take_power(std::size_t axis, SdoClient& client) {
  const auto has_power = [](DriveState state) {
    return state == DriveState::operation_enabled || state == DriveState::quick_stop_active;
  };
  for (const std::uint16_t word : {kQuickStop, kDisableVoltage}) {
    if (!has_power(read_state(axis, client))) return;
    download_repeated(client, drives_[axis].node(), object_of(axis, kControlword), word, 2);
    const std::int64_t end = clock::monotonic_ns() + std::llround(table_.switch_on_time * clock::kSecond);
    while (clock::monotonic_ns() < end)
      if (!has_power(read_state(axis, client))) return;
  }
  fail(ErrorCode::drive_not_ready, axis, "keeps its power against its controlword");
}

/// An earlier run has left it without a heartbeat: depending on 6007h, it has slowed down and is in a fault.
void CanHardware::clear_fault(std::size_t axis, SdoClient& client) {
  const NodeId node = drives_[axis].node();
  const std::int64_t end = clock::monotonic_ns() + std::llround(table_.switch_on_time * clock::kSecond);
  for (;;) {
    const DriveState state = read_state(axis, client);
    if (state != DriveState::fault && state != DriveState::fault_reaction_active) return;
    if (clock::monotonic_ns() > end) break;
    if (state == DriveState::fault)
      for (const std::uint16_t word : {kDisableVoltage, kFaultReset, kDisableVoltage})
        download_repeated(client, node, object_of(axis, kControlword), word, 2);
  }
  std::uint16_t code = 0;
  try {
    code = static_cast<std::uint16_t>(can::get(client.upload(node, object_of(axis, kErrorCode)), 0, 2));
  } catch (const SdoError&) {
    fail(ErrorCode::drive_fault, axis, "stays in its fault, and reports no error code");
  }
  std::array<char, 8> number{};
  std::snprintf(number.data(), number.size(), "%04Xh", code);
  fail(ErrorCode::drive_fault, axis,
       std::string("stays in its fault: error code ").append(number.data()).append(", ").append(error_text(code)));
}

void CanHardware::prepare_axes(std::size_t first, SdoClient& client) {
  for (std::size_t i = first; i < drives_.size(); ++i)
    if (drives_[i].node() == drives_[first].node()) prepare_drive(i, client);
}

void CanHardware::prepare_drive(std::size_t axis, SdoClient& client) {
  const NodeId node = drives_[axis].node();
  const std::vector<std::uint8_t> type = upload_repeated(client, node, kDeviceType);
  if (can::get(type, 0, 2) != kProfile402)
    fail(ErrorCode::configuration, axis,
         "profile " + std::to_string(can::get(type, 0, 2)) + " in its device type, expected 402, a drive");
  check_modes(axis, client);
  take_power(axis, client);
  clear_fault(axis, client);
  send(nmt_frame(NmtCommand::enter_pre_operational, node));
  const int offset = table_.drives[axis].first_pdo - 1;
  for (const int parameters : {int{kReceivePdoParameters}, int{kTransmitPdoParameters}, kTransmitPdoParameters + 1})
    free_pdo(client, node, static_cast<std::uint16_t>(parameters + offset));
}

}  // namespace mrroc::edp
