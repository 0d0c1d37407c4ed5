// Brings the nodes of the bus into service before the servo's first tick.
#include <algorithm>
#include <cmath>

#include "clock/wall/monotonic.hpp"
#include "drivers/socketcan/can_hardware.hpp"
#include "drivers/socketcan/repeated_sdo.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::edp {

using namespace canopen;
using can::BusError;

namespace {

/// The frames of the drives and I/O nodes, and those that only their master may send.
std::vector<can::Filter> filters_for(const std::vector<Drive>& drives, const IoNodes& io,
                                     const config::DriveTable& table) {
  std::vector<can::Filter> filters{
      {kNmt, 0x7ff}, {table.sync, 0x7ff}, {kHeartbeat + table.master, 0x7ff}, {can::kReturnedFence, 0x7ff}};
  for (const Drive& drive : drives) {
    for (const std::uint32_t function : {kTransmitPdo1, kTransmitPdo1 + 0x100, kReceivePdo1})
      filters.push_back({function + drive.pdo_node(), 0x7ff});
    if (!drive.leads()) continue;
    for (const std::uint32_t function : {kEmergency, kSdoResponse, kHeartbeat})
      filters.push_back({function + drive.node(), 0x7ff});
  }
  io.add_filters(filters);
  return filters;
}

constexpr std::int64_t kBetweenResets = clock::kSecond / 2;
constexpr double kStartTimeout = 60;  // s of wall time, for simulated nodes in lockstep to start
constexpr int kMostBoots = 5;
constexpr int kFirstSyncs = 50;

bool is_boot_up(const can::Frame& frame, NodeId node) { return frame == heartbeat_frame(node, NmtState::boot_up); }

}  // namespace

NodeId CanHardware::node_at(std::size_t place) const noexcept {
  return is_drive(place) ? drives_[place].node() : io_.all()[place - drives_.size()].node();
}

NodeSetup& CanHardware::setup_at(std::size_t place) noexcept {
  return is_drive(place) ? drives_[place].setup() : io_node(place).setup();
}

void CanHardware::fail(ErrorCode code, std::size_t place, const std::string& what) const {
  const bool cause = code == ErrorCode::hardware_silent && bus_error_ != BusError::none;
  std::string text = is_drive(place) ? "drive " + table_.drives[place].axis : "I/O";
  text += ", node " + std::to_string(node_at(place));
  if (is_drive(place) && drives_[place].channel() != 1) text += ", channel " + std::to_string(drives_[place].channel());
  text += ": " + what;
  if (cause) text.append(" (").append(can::describe(bus_error_)).append(")");
  throw HardwareError(code, text);
}

/// In lockstep a slow machine must not change the start.
std::int64_t CanHardware::sdo_timeout() const noexcept {
  return timing_.fenced ? std::llround(timing_.timeout * clock::kSecond) : kSdoTimeout;
}

void CanHardware::open() {
  bus_ = open_bus_();
  bus_->filter(filters_for(drives_, io_, table_));
  await_boot();
  set_up_all();
  for (Drive& drive : drives_) {
    if (drive.leads()) send(nmt_frame(NmtCommand::start, drive.node()));
    drive.begin(0);
  }
  for (IoNode& node : io_.all()) {
    send(nmt_frame(NmtCommand::start, node.node()));
    node.begin(0);
  }
  await_first_answers();
  bus_error_ = BusError::none;  // from resets without acknowledgement, while drives had no power
}

/// A reset may reach a node late, after the next one has been sent: it boots twice, and loses its settings.
void CanHardware::note(const can::Frame& frame) {
  if (frame.error) return take_error(frame);
  for (std::size_t i = 0; i < places(); ++i)
    if (is_boot_up(frame, node_at(i)) && sets_up(i)) set_up_[i] = false;
}

void CanHardware::set_up_all() {
  set_up_.assign(places(), true);
  for (std::size_t i = 0; i < places(); ++i) set_up_[i] = !sets_up(i);
  std::vector<int> boots(places(), 0);
  for (;;) {
    can::Frame frame;
    while (bus_->receive(frame, 0)) note(frame);
    const auto next = std::find(set_up_.begin(), set_up_.end(), false);
    if (next == set_up_.end()) return;
    const auto place = static_cast<std::size_t>(next - set_up_.begin());
    if (++boots[place] > kMostBoots)
      fail(is_drive(place) ? ErrorCode::drive_restarted : ErrorCode::io_fault, place, "it boots again and again");
    set_up_[place] = true;
    set_up(place);
  }
}

/// Resets the communication that an earlier run has set up in every node. A drive's profile keeps state, error and
/// values: a reset of the node would take seconds in some drives, and they would count from zero again.
void CanHardware::await_boot() {
  std::vector<bool> booted(places(), false);
  const auto missing = [&booted] { return std::find(booted.begin(), booted.end(), false); };
  const double timeout = timing_.fenced ? kStartTimeout : timing_.boot_timeout;
  const std::int64_t end = clock::monotonic_ns() + std::llround(timeout * clock::kSecond);
  while (missing() != booted.end()) {
    for (std::size_t i = 0; i < places(); ++i)
      if (!booted[i] && sets_up(i)) send(nmt_frame(NmtCommand::reset_communication, node_at(i)));
    const std::int64_t again = clock::monotonic_ns() + kBetweenResets;
    can::Frame frame;
    while (missing() != booted.end() && bus_->receive(frame, again)) {
      if (frame.error) take_error(frame);
      for (std::size_t i = 0; i < places(); ++i)
        if (is_boot_up(frame, node_at(i))) booted[i] = true;
    }
    if (clock::monotonic_ns() > end && missing() != booted.end())
      fail(ErrorCode::hardware_silent, static_cast<std::size_t>(missing() - booted.begin()),
           "no boot-up message within " + std::to_string(static_cast<int>(timeout)) +
               " s of its reset: no power, another node number or bit rate, or no wire");
  }
}

void CanHardware::set_up(std::size_t place) {
  SdoClient client(*bus_, sdo_timeout(), [this](const can::Frame& frame) { note(frame); });
  try {
    is_drive(place) ? prepare_axes(place, client) : prepare_io_node(place, client);
  } catch (const SdoError& error) {
    if (!set_up_[place]) return;  // it has booted in the meantime
    fail(error.abort() == SdoAbort::timeout ? ErrorCode::hardware_silent : ErrorCode::configuration, place,
         error.what());
  }
  write_settings(place);
}

void CanHardware::write_settings(std::size_t place) {
  NodeSetup& setup = setup_at(place);
  begin_set_up(node_at(place), setup.start());
  std::int64_t deadline = clock::monotonic_ns() + sdo_timeout();
  bool asked_again = false;
  while (setup.status() == NodeSetup::Status::writing) {
    can::Frame frame, next;
    if (bus_->receive(frame, deadline)) {
      note(frame);
      if (!set_up_[place]) return setup.give_up();  // to begin again
      setup.take(frame, next);
    }
    if (next.size != 0) {
      asked_again = false;
    } else if (clock::monotonic_ns() > deadline) {
      if (asked_again) fail(ErrorCode::hardware_silent, place, "no answer to writing " + setup.setting().name);
      asked_again = true;  // a frame may be lost, and this process may have been preempted
      next = setup.again();
    } else {
      continue;
    }
    send(next);
    deadline = clock::monotonic_ns() + sdo_timeout();
  }
  if (setup.status() == NodeSetup::Status::refused)
    fail(ErrorCode::configuration, place,
         "refuses " + setup.setting().name + " = " + std::to_string(setup.setting().value) + ": " +
             std::string(describe(setup.abort())));
  setup.give_up();
}

bool CanHardware::all_answer() const noexcept {
  return std::all_of(drives_.begin(), drives_.end(),
                     [](const Drive& drive) { return drive.answered() && drive.knows_switches(); }) &&
         std::all_of(io_.all().begin(), io_.all().end(), [](const IoNode& node) { return node.knows_inputs(); });
}

/// Runs cycles at the servo's rate until each drive has answered and reported its switches, each I/O node its inputs.
void CanHardware::await_first_answers() {
  const std::int64_t between = std::llround(period_ * clock::kSecond);
  for (int i = 0; i < kFirstSyncs + table_.status_every; ++i) {
    for (Drive& drive : drives_) drive.expect();
    const std::int64_t next_sync = clock::monotonic_ns() + between;
    send(sync_frame(table_.sync));
    await_answers(clock::monotonic_ns() + kSdoTimeout / 10);
    if (all_answer()) {
      for (Drive& drive : drives_) drive.close_cycle();
      return;
    }
    if (nodes_lost_) break;
    can::Frame frame;
    while (!timing_.fenced && clock::monotonic_ns() < next_sync && bus_->receive(frame, next_sync)) dispatch(frame);
  }
  for (std::size_t i = 0; i < places(); ++i) {
    if (!is_drive(i)) {
      if (!io_node(i).knows_inputs()) fail(ErrorCode::hardware_silent, i, "no TPDO with its inputs at any SYNC");
    } else if (!drives_[i].answered()) {
      fail(ErrorCode::hardware_silent, i, "no answer to a SYNC");
    } else if (!drives_[i].knows_switches()) {
      fail(ErrorCode::hardware_silent, i, "no TPDO 2 (velocity, switches) at any SYNC");
    }
  }
}

}  // namespace mrroc::edp
