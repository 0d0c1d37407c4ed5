// Frames of any content in any order: their description, a transfer that waits for an answer, the EDP's side of a
// drive, and a simulated drive.
#include <algorithm>
#include <cmath>

#include "canopen/emergency.hpp"
#include "canopen/sdo.hpp"
#include "cli/can/can_frame_formatter.hpp"
#include "cli/can/can_nodes.hpp"
#include "drivers/socketcan/drive.hpp"
#include "fuzz/can_frame.hpp"

namespace {

using namespace mrroc;
using namespace mrroc::canopen;
using fuzz::check_sent;

constexpr Tick kReset = 50;  // ticks between two attempts to recover

void check_words(const std::string& text) {
  fuzz::require(!text.empty(), "every frame has a description");
  fuzz::require(std::all_of(text.begin(), text.end(), [](char letter) { return letter >= 0x20 && letter < 0x7f; }),
                "a description is one printable line");
}

/// The EDP's side: a drive in every mode, ticks at each SYNC.
class Master {
 public:
  explicit Master(const config::DriveTable& table) : drive_(table, table.drives[0], 0.002, 0.1) {
    drive_.setup().start();
    drive_.begin(0);
    drive_.enable(true, 0);
  }

  void take(const can::Frame& frame) {
    can::Frame next;
    drive_.take(frame, tick_, next);
    check_sent(next);
    if (frame.id != kSync) return;
    drive_.expect();
    ++tick_;
    drive_.close_cycle();
    if (tick_ % kReset == 0) drive_.reset(tick_, drive_.position(), !drive_.serves(), next);
    if (tick_ % kReset == kReset / 2) drive_.enable(true, tick_);
    if (tick_ % kReset == kReset - 5) drive_.home();
    if (drive_.asks(tick_, next)) check_sent(next);
    drive_.fault(tick_);
    drive_.busy(tick_);
    fuzz::require(
        std::isfinite(drive_.position()) && std::isfinite(drive_.velocity()) && std::isfinite(drive_.current()),
        "a measured value is a number");
    const can::Frame command = drive_.command({1, drive_.position(), 1});
    check_sent(command);
    fuzz::require(command.id == kReceivePdo1 + drive_.node() && command.size > 0, "a drive is commanded in every tick");
  }

 private:
  edp::Drive drive_;
  Tick tick_ = 0;
};

/// A simulated drive with a motor at rest.
class Slave {
 public:
  Slave(const config::DriveTable& table, const AxisParameters& axis)
      : node_(table, table.drives[0], axis, 0.002, &fuzz::check_sent) {
    node_.boot(0);
  }

  void take(const can::Frame& frame) {
    now_ += 1'000'000;
    node_.take(frame, now_);
    node_.update(now_);
    if (frame.id != kSync || frame.error) return;
    node_.measure(0, 0, {});
    node_.synchronise();
    node_.send_status();
    node_.send_feedback();
    fuzz::require(std::isfinite(node_.drive()), "a motor's current is a number");
  }

 private:
  sim::DriveNode node_;
  std::int64_t now_ = 0;
};

/// A transfer at each request of the master, like a client of the addressed node.
void follow(SdoTransfer& transfer, const can::Frame& frame, const Object& object, bool writes) {
  can::Frame next;
  const bool waits = transfer.status() == SdoTransfer::Status::waiting;
  const bool taken = transfer.take(frame, next);
  fuzz::require(!taken || waits, "only a waiting transfer gets an answer");
  fuzz::require(transfer.value().size() <= kMaxValue, "a value has a maximum size");
  check_sent(next);
  if (transfer.status() != SdoTransfer::Status::waiting)
    writes ? transfer.download(1, object, transfer.value()) : transfer.upload(1, object);
}

/// In each mode, set-points at once or at the SYNC, counting forwards or backwards.
std::vector<config::DriveTable> every_table() {
  std::vector<config::DriveTable> tables(12, cli::irb6_drives());
  for (std::size_t i = 0; i < tables.size(); ++i) {
    tables[i].mode = static_cast<DriveMode>(8 + i % 3);
    tables[i].target_at_sync = i % 2 == 0;
    if (i >= 6) tables[i].drives[0].units_per_turn *= -1;
  }
  return tables;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto tables = every_table();
  static const RobotParameters robot = cli::irb6_parameters();
  fuzz::Bytes input(data, size);
  const config::DriveTable& own = tables[input.take<std::uint8_t>() % tables.size()];
  cli::CanFrameFormatter words(own), without;
  Master master(own);
  Slave slave(own, robot.axes[0]);
  SdoTransfer reads, writes;
  reads.upload(1, kDeviceName);
  writes.download(1, kDeviceName, std::array<std::uint8_t, 20>{});
  while (!input.empty()) {
    const can::Frame frame = fuzz::take_frame(input);
    check_words(words.line(frame));
    check_words(without.line(frame));
    if (const auto emergency = emergency_of(frame))
      fuzz::require(!error_text(emergency->code).empty() && to_frame(*emergency) == frame, "an emergency round-trips");
    follow(reads, frame, kDeviceName, false);
    follow(writes, frame, kDeviceName, true);
    master.take(frame);
    slave.take(frame);
  }
  return 0;
}
