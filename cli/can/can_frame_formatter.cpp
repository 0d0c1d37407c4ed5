#include "cli/can/can_frame_formatter.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <numbers>

#include "canopen/drive_words.hpp"
#include "canopen/frame_text.hpp"
#include "canopen/object_value.hpp"

namespace mrroc::cli {

namespace {

using namespace canopen;

constexpr std::uint32_t kFunction = 0x780, kNode = 0x7f;

double radians(std::int64_t units, double units_per_turn) {
  return static_cast<double>(units) * 2 * std::numbers::pi / units_per_turn;
}

double amperes(const config::DriveEntry& entry, std::int64_t per_mille) {
  return static_cast<double>(per_mille) / 1000 * std::copysign(entry.rated_current, entry.units_per_turn);
}

/// The object of an SDO's first frame, followed by its name.
void name_object(std::string& text, const can::Frame& frame, const EdsFile& eds) {
  const Object object{static_cast<std::uint16_t>(can::get(frame.bytes(), 1, 2)), frame.data[3]};
  const std::string address = to_text(object);
  const std::size_t place = text.find(address);
  const ObjectEntry* const entry = eds.find(object);
  if (place != std::string::npos && entry != nullptr) text.insert(place + address.size(), " (" + entry->name + ")");
}

}  // namespace

CanFrameFormatter::CanFrameFormatter(config::DriveTable table)
    : table_(std::move(table)), pdos_(edp::drive_pdos(table_->mode)) {
  for (const config::DriveEntry& entry : table_->drives) drives_.emplace(entry.node, Named{entry, table_->mode});
}

void CanFrameFormatter::add(const config::IoTable& io) {
  for (const config::IoEntry& entry : io.nodes) io_.emplace(entry.node, IoFrameText{entry});
}

std::string CanFrameFormatter::whose(unsigned node) const {
  if (const auto found = drives_.find(node); found != drives_.end()) return found->second.entry.axis;
  if (const auto found = io_.find(node); found != io_.end()) return found->second.name();
  if (table_ && node == table_->master) return "master";
  return "node " + std::to_string(node);
}

std::string CanFrameFormatter::line(const can::Frame& frame) {
  if (frame.error || frame.remote || frame.fd || (!table_ && io_.empty())) return to_text(frame);
  const unsigned node = frame.id & kNode;
  const std::uint32_t function = frame.id & kFunction;
  if (const auto found = drives_.find(node); found != drives_.end())
    if (const auto words = process_data(frame, found->second)) return found->second.entry.axis + " " + *words;
  const auto io = io_.find(node);
  if (io != io_.end())
    if (const auto words = io->second.process_data(frame)) return io->second.name() + " " + *words;
  std::string text = to_text(frame);
  if ((function == kSdoRequest || function == kSdoResponse) && frame.size == can::kMaxClassicalData) {
    if (io != io_.end())
      name_object(text, frame, io->second.eds());
    else if (table_)
      name_object(text, frame, table_->eds);
  }
  const bool to_one = frame.id == kNmt && frame.size == 2 && frame.data[1] != 0;
  const unsigned meant = to_one ? frame.data[1] : node;
  const std::string number = "node " + std::to_string(meant);
  if (const std::size_t place = text.find(number + (to_one ? ":" : " ")); place != std::string::npos)
    text.replace(place, number.size(), whose(meant));
  return text;
}

/// Nothing when the frame is too short or is not one of the PDOs that an EDP and its drives exchange.
std::optional<std::string> CanFrameFormatter::process_data(const can::Frame& frame, Named& drive) const {
  const config::DriveEntry& entry = drive.entry;
  std::int64_t first = 0, second = 0, third = 0;
  switch (frame.id & kFunction) {
    case kTransmitPdo1:
      if (!pdos_.feedback.read(frame, kStatusword, false, first) ||
          !pdos_.feedback.read(frame, kPositionActual, true, second) ||
          !pdos_.feedback.read(frame, kTorqueActual, true, third))
        return {};
      return fmt::format("TPDO 1: {}; {:.5f} rad, {:.3f} A",
                         statusword_text(static_cast<std::uint16_t>(first), drive.mode),
                         radians(second, entry.units_per_turn), amperes(entry, third));
    case kTransmitPdo1 + 0x100:
      if (!pdos_.status.read(frame, kVelocityActual, true, first) ||
          !pdos_.status.read(frame, kDigitalInputs, false, second))
        return {};
      return fmt::format("TPDO 2: {:.4f} rad/s; {}", radians(first, entry.velocity_units_per_turn),
                         switches_text(static_cast<std::uint32_t>(second)));
    case kReceivePdo1:
      if (frame.size < pdos_.command.size()) return {};
      return command(frame, drive);
    default:
      return {};
  }
}

std::string CanFrameFormatter::command(const can::Frame& frame, Named& drive) const {
  const config::DriveEntry& entry = drive.entry;
  std::int64_t controlword = 0, mode = 0, target = 0;
  pdos_.command.read(frame, kControlword, false, controlword);
  pdos_.command.read(frame, kMode, true, mode);
  drive.mode = static_cast<DriveMode>(mode);
  std::string text = fmt::format(
      "RPDO 1: {}; {}", controlword_text(static_cast<std::uint16_t>(controlword), drive.mode), describe(drive.mode));
  if (pdos_.command.read(frame, kTargetPosition, true, target))
    text += fmt::format(", {:.5f} rad", radians(target, entry.units_per_turn));
  if (pdos_.command.read(frame, kTargetVelocity, true, target))
    text += fmt::format(", {:.4f} rad/s", radians(target, entry.velocity_units_per_turn));
  if (pdos_.command.read(frame, kTargetTorque, true, target)) text += fmt::format(", {:.3f} A", amperes(entry, target));
  return text;
}

std::string CanFrameFormatter::kind(std::uint32_t id) const {
  if (id == kNmt) return "NMT";
  if (id == kSync || (table_ && id == table_->sync)) return "SYNC";
  if (id == kTime) return "TIME";
  const unsigned node = id & kNode;
  const std::uint32_t function = id & kFunction;
  if (node == 0) return "";
  if (function == kEmergency) return whose(node) + " emergency";
  if (function == kSdoResponse) return whose(node) + " SDO answers";
  if (function == kSdoRequest) return whose(node) + " SDO requests";
  if (function == kHeartbeat) return whose(node) + " heartbeat";
  if (function < kTransmitPdo1 || function > kSdoResponse) return "";
  const std::uint32_t number = (function - kTransmitPdo1) / 0x100 + 1;
  return whose(node) + ((function - kTransmitPdo1) % 0x100 == 0 ? " TPDO " : " RPDO ") + std::to_string(number);
}

}  // namespace mrroc::cli
