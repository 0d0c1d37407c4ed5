#include "sim/can/channel.hpp"

#include <algorithm>

#include "canopen/objects.hpp"

namespace mrroc::sim {

using namespace canopen;

namespace {

constexpr std::uint16_t kPdoBlock = 0x200;
constexpr std::uint8_t kSpecifier = 0xe0, kDownload = 0x20, kAnsweredUpload = 0x40;

bool is_of_pdo(std::uint16_t index) {
  return index >= kReceivePdoParameters && index < kTransmitPdoMapping + kPdoBlock;
}

bool is_mapping(std::uint16_t index) {
  return is_of_pdo(index) && (index / kPdoBlock) % 2 == (kReceivePdoMapping / kPdoBlock) % 2;
}

bool is_of_profile(std::uint16_t index) { return canopen::is_of_profile(Object{index}); }

std::uint16_t index_of(const can::Frame& frame) { return static_cast<std::uint16_t>(can::get(frame.data, 1, 2)); }

void set_index(can::Frame& frame, int index) { can::put(frame.data, 1, 2, static_cast<std::uint64_t>(index)); }

/// Moves the object in an entry of a mapping.
void move_entry(can::Frame& frame, int by) {
  const auto index = static_cast<std::uint16_t>(can::get(frame.data, 6, 2));
  if (frame.data[3] != 0 && is_of_profile(index)) can::put(frame.data, 6, 2, static_cast<std::uint16_t>(index + by));
}

}  // namespace

Channel::Channel(const config::DriveTable& table, const config::DriveEntry& entry) : node_(entry.node) {
  for (const config::DriveEntry& drive : table.drives) {
    if (drive.node != entry.node) continue;
    if (drive.channel == entry.channel) own_ = axes_.size();
    axes_.push_back({drive.channel, drive.first_pdo});
  }
}

/// The axis to which an object belongs; null: to all, or to none.
const Channel::Axis* Channel::axis_of(std::uint16_t index) const {
  const Axis* found = nullptr;
  for (const Axis& axis : axes_) {
    const int number = index % kPdoBlock + 1;
    const bool its_pdo =
        is_of_pdo(index) && number >= axis.first_pdo && (found == nullptr || axis.first_pdo > found->first_pdo);
    const bool its_profile = is_of_profile(index) && (index - kProfile) / kObjectsOfChannel + 1 == axis.channel;
    if (its_pdo || its_profile) found = &axis;
  }
  return found;
}

std::optional<can::Frame> Channel::received(const can::Frame& frame) const {
  if (axes_.size() < 2 || frame.id != kSdoRequest + node_ || frame.size != 8) return frame;
  const Axis* const axis = axis_of(index_of(frame));
  if (axis == nullptr) return frame;
  if (axis != &axes_[own_]) return {};
  can::Frame own = frame;
  const int by = -kObjectsOfChannel * (axis->channel - 1);
  set_index(own, index_of(frame) + (is_of_profile(index_of(frame)) ? by : 1 - axis->first_pdo));
  if ((frame.data[0] & kSpecifier) == kDownload && is_mapping(index_of(frame))) move_entry(own, by);
  return own;
}

std::optional<can::Frame> Channel::sent(const can::Frame& frame) const {
  const Axis& axis = axes_[own_];
  const bool first = own_ == 0;
  if (axes_.size() < 2 || frame.error) return frame;
  if (frame.id == kHeartbeat + node_) return first ? std::optional(frame) : std::nullopt;
  if (frame.id != kSdoResponse + node_ || frame.size != 8) return frame;
  can::Frame of_node = frame;
  const std::uint16_t index = index_of(frame);
  const int by = kObjectsOfChannel * (axis.channel - 1);
  if (!is_of_profile(index) && !is_of_pdo(index)) return first ? std::optional(frame) : std::nullopt;
  set_index(of_node, index + (is_of_profile(index) ? by : axis.first_pdo - 1));
  if ((frame.data[0] & kSpecifier) == kAnsweredUpload && is_mapping(index)) move_entry(of_node, by);
  return of_node;
}

}  // namespace mrroc::sim
