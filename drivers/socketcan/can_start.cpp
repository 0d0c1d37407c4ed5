// Brings the drives into service before the servo's first tick.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "canopen/emergency.hpp"
#include "canopen/sdo_client.hpp"
#include "clock/wall/monotonic.hpp"
#include "drivers/socketcan/can_hardware.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::edp {

using namespace canopen;
using can::BusError;

namespace {

/// The frames of the drives, and those that only their master may send.
std::vector<can::Filter> filters_for(const std::vector<Drive>& drives, NodeId master) {
  std::vector<can::Filter> filters{{kNmt, 0x7ff}, {kSync, 0x7ff}, {kHeartbeat + master, 0x7ff}};
  for (const Drive& drive : drives)
    for (const std::uint32_t function :
         {kTransmitPdo1, kTransmitPdo1 + 0x100, kEmergency, kSdoResponse, kHeartbeat, kReceivePdo1})
      filters.push_back({function + drive.node(), 0x7ff});
  return filters;
}

constexpr std::int64_t kPatienceWithSdo = clock::kSecond / 2;
constexpr std::int64_t kBetweenResets = clock::kSecond / 2;
constexpr std::int64_t kBetweenLooks = clock::kSecond / 100;
constexpr int kMostBoots = 5;
constexpr int kFirstSyncs = 50;
constexpr std::uint32_t kProfile402 = 402;

bool is_boot_up(const can::Frame& frame, NodeId node) { return frame == heartbeat_frame(node, NmtState::boot_up); }

/// Repeats an SDO request once without an answer: a drive that is booting does not answer.
template <class Transfer>
auto patiently(Transfer transfer) {
  try {
    return transfer();
  } catch (const SdoError& error) {
    if (error.abort() != SdoAbort::timeout) throw;
  }
  return transfer();
}

std::vector<std::uint8_t> upload_patiently(SdoClient& client, NodeId node, Object object) {
  return patiently([&] { return client.upload(node, object); });
}

void download_patiently(SdoClient& client, NodeId node, Object object, std::uint32_t value, std::uint8_t size) {
  patiently([&] { client.download(node, object, value, size); });
}

}  // namespace

void CanHardware::fail(ErrorCode code, std::size_t axis, const std::string& what) const {
  const config::DriveEntry& entry = table_.drives[axis];
  const bool cause = code == ErrorCode::hardware_silent && bus_error_ != BusError::none;
  throw HardwareError(code, "drive " + entry.axis + ", node " + std::to_string(entry.node) + ": " + what +
                                (cause ? std::string(" (") + can::describe(bus_error_) + ")" : ""));
}

void CanHardware::open() {
  bus_ = open_bus_();
  bus_->filter(filters_for(drives_, table_.master));
  await_boot();
  set_up_all();
  for (Drive& drive : drives_) {
    send(nmt_frame(NmtCommand::start, drive.node()));
    drive.begin(0);
  }
  await_answers();
  bus_error_ = BusError::none;  // from resets without acknowledgement, while drives had no power
}

/// A reset may reach a drive late, after the next one has been sent: it boots twice, and loses its settings.
void CanHardware::note(const can::Frame& frame) {
  if (frame.error) return take_error(frame);
  for (std::size_t i = 0; i < drives_.size(); ++i)
    if (is_boot_up(frame, drives_[i].node())) set_up_[i] = false;
}

void CanHardware::set_up_all() {
  set_up_.assign(drives_.size(), false);
  std::vector<int> boots(drives_.size(), 0);
  for (;;) {
    can::Frame frame;
    while (bus_->receive(frame, 0)) note(frame);
    const auto next = std::find(set_up_.begin(), set_up_.end(), false);
    if (next == set_up_.end()) return;
    const auto axis = static_cast<std::size_t>(next - set_up_.begin());
    if (++boots[axis] > kMostBoots) fail(ErrorCode::drive_restarted, axis, "it boots again and again");
    set_up_[axis] = true;
    set_up(axis);
  }
}

/// Resets the communication that an earlier run has set up in every drive. Its profile keeps state, error and values: a
/// reset of the node would take seconds in some drives, and they would count from zero again.
void CanHardware::await_boot() {
  std::vector<bool> booted(drives_.size(), false);
  const auto missing = [&booted] { return std::find(booted.begin(), booted.end(), false); };
  const std::int64_t end = clock::monotonic_ns() + std::llround(kPatienceWithBoot * clock::kSecond);
  while (missing() != booted.end()) {
    for (std::size_t i = 0; i < drives_.size(); ++i)
      if (!booted[i]) send(nmt_frame(NmtCommand::reset_communication, drives_[i].node()));
    const std::int64_t again = clock::monotonic_ns() + kBetweenResets;
    can::Frame frame;
    while (missing() != booted.end() && bus_->receive(frame, again)) {
      if (frame.error) take_error(frame);
      for (std::size_t i = 0; i < drives_.size(); ++i)
        if (is_boot_up(frame, drives_[i].node())) booted[i] = true;
    }
    if (clock::monotonic_ns() > end && missing() != booted.end())
      fail(ErrorCode::hardware_silent, static_cast<std::size_t>(missing() - booted.begin()),
           "no boot-up message within " + std::to_string(static_cast<int>(kPatienceWithBoot)) +
               " s of its reset: no power, another node number or bit rate, or no wire");
  }
}

/// Checks the mode: a drive may accept a mode that it does not have, and stay in another.
void CanHardware::check_modes(std::size_t axis, SdoClient& client) const {
  if (table_.eds.find(kSupportedModes) == nullptr) return;
  std::uint64_t supported = 0;
  try {
    supported = can::get(upload_patiently(client, drives_[axis].node(), kSupportedModes), 0, 4);
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
  send(sync_frame());  // simulated drives may advance only with it
  can::Frame frame;
  const std::int64_t next_look = clock::monotonic_ns() + kBetweenLooks;
  while (clock::monotonic_ns() < next_look && bus_->receive(frame, next_look)) note(frame);
  const auto statusword = upload_patiently(client, drives_[axis].node(), kStatusword);
  return drive_state(static_cast<std::uint16_t>(can::get(statusword, 0, 2)));
}

/// Its 6007h, or a program of its manufacturer, may have kept it on: it would follow values written now at once.
void CanHardware::take_power(std::size_t axis, SdoClient& client) {
  const auto has_power = [](DriveState state) {
    return state == DriveState::operation_enabled || state == DriveState::quick_stop_active;
  };
  for (const std::uint16_t word : {kQuickStop, kDisableVoltage}) {
    if (!has_power(read_state(axis, client))) return;
    download_patiently(client, drives_[axis].node(), kControlword, word, 2);
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
        download_patiently(client, node, kControlword, word, 2);
  }
  std::uint16_t code = 0;
  try {
    code = static_cast<std::uint16_t>(can::get(client.upload(node, kErrorCode), 0, 2));
  } catch (const SdoError&) {
    fail(ErrorCode::drive_fault, axis, "stays in its fault, and reports no error code");
  }
  std::array<char, 8> number{};
  std::snprintf(number.data(), number.size(), "%04Xh", code);
  fail(ErrorCode::drive_fault, axis,
       std::string("stays in its fault: error code ").append(number.data()).append(", ").append(error_text(code)));
}

/// A PDO in use keeps its identifier (CiA 301), and the drive may have its own from its last set-up (1010h).
void CanHardware::free_pdos(std::size_t axis, SdoClient& client) {
  const NodeId node = drives_[axis].node();
  for (const std::uint16_t index :
       {kReceivePdoParameters, kTransmitPdoParameters, static_cast<std::uint16_t>(kTransmitPdoParameters + 1)}) {
    const auto identifier = static_cast<std::uint32_t>(can::get(upload_patiently(client, node, {index, 1}), 0, 4));
    if ((identifier & kPdoNotUsed) == 0) download_patiently(client, node, {index, 1}, kPdoNotUsed | identifier, 4);
  }
}

void CanHardware::set_up(std::size_t axis) {
  Drive& drive = drives_[axis];
  SdoClient client(*bus_, kPatienceWithSdo, [this](const can::Frame& frame) { note(frame); });
  try {
    const std::vector<std::uint8_t> type = upload_patiently(client, drive.node(), kDeviceType);
    if (can::get(type, 0, 2) != kProfile402)
      fail(ErrorCode::configuration, axis,
           "profile " + std::to_string(can::get(type, 0, 2)) + " in its device type, expected 402, a drive");
    check_modes(axis, client);
    take_power(axis, client);
    clear_fault(axis, client);
    send(nmt_frame(NmtCommand::enter_pre_operational, drive.node()));
    free_pdos(axis, client);
  } catch (const SdoError& error) {
    if (!set_up_[axis]) return;  // it has booted in the meantime
    fail(error.abort() == SdoAbort::timeout ? ErrorCode::hardware_silent : ErrorCode::configuration, axis,
         error.what());
  }
  begin_set_up(drive, drive.setup().start());
  std::int64_t deadline = clock::monotonic_ns() + kPatienceWithSdo;
  bool asked_again = false;
  while (drive.setup().status() == NodeSetup::Status::writing) {
    can::Frame frame, next;
    if (bus_->receive(frame, deadline)) {
      note(frame);
      if (!set_up_[axis]) return drive.setup().give_up();  // to begin again
      drive.setup().take(frame, next);
    }
    if (next.size != 0) {
      asked_again = false;
    } else if (clock::monotonic_ns() > deadline) {
      if (asked_again) fail(ErrorCode::hardware_silent, axis, "no answer to writing " + drive.setup().setting().name);
      asked_again = true;  // a frame may be lost, and this process may have been preempted
      next = drive.setup().again();
    } else {
      continue;
    }
    send(next);
    deadline = clock::monotonic_ns() + kPatienceWithSdo;
  }
  if (drive.setup().status() == NodeSetup::Status::refused)
    fail(ErrorCode::configuration, axis,
         "refuses " + drive.setup().setting().name + " = " + std::to_string(drive.setup().setting().value) + ": " +
             std::string(describe(drive.setup().abort())));
  drive.setup().give_up();
}

/// Runs cycles at the servo's rate until each drive has answered and reported its switches.
void CanHardware::await_answers() {
  const auto ready = [](const Drive& drive) { return drive.answered() && drive.knows_switches(); };
  const std::int64_t between = std::llround(period_ * clock::kSecond);
  for (int i = 0; i < kFirstSyncs + table_.status_every; ++i) {
    for (Drive& drive : drives_) drive.expect();
    const std::int64_t next_sync = clock::monotonic_ns() + between;
    send(sync_frame());
    await_all(clock::monotonic_ns() + kPatienceWithSdo / 10);
    if (std::all_of(drives_.begin(), drives_.end(), ready)) {
      for (Drive& drive : drives_) drive.close_cycle();
      return;
    }
    can::Frame frame;
    while (clock::monotonic_ns() < next_sync && bus_->receive(frame, next_sync)) dispatch(frame);
  }
  for (std::size_t i = 0; i < drives_.size(); ++i)
    if (!ready(drives_[i]))
      fail(ErrorCode::hardware_silent, i,
           drives_[i].answered() ? "no TPDO 2 (velocity, switches) at any SYNC" : "no answer to a SYNC");
}

}  // namespace mrroc::edp
