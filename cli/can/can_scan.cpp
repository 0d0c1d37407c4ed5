#include "cli/can/can_scan.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <deque>

#include "canopen/object_value.hpp"
#include "canopen/sdo.hpp"
#include "clock/wall/monotonic.hpp"

namespace mrroc::cli {

namespace {

using namespace canopen;

constexpr std::int64_t kRetry = clock::kSecond / 1000;  // between two attempts to send while the queue is full

constexpr Object kQuestions[] = {kDeviceType, kDeviceName, kVendor, kProduct, kRevision, kSerialNumber};

/// The requests to one node, one after the other.
class Inquiry {
 public:
  explicit Inquiry(NodeId node) { found_.node = node; }

  can::Frame ask() noexcept { return transfer_.upload(found_.node, kQuestions[place_]); }

  /// Takes a frame; the caller sends `next` when it has an identifier.
  void take(const can::Frame& frame, can::Frame& next) {
    next = {};
    if (!frame.error && !frame.remote && frame.size == 1 && frame.id == kHeartbeat + found_.node) {
      found_.state = static_cast<NmtState>(frame.data[0] & 0x7f);
    } else if (transfer_.take(frame, next)) {
      heard_ = true;
      if (transfer_.status() == SdoTransfer::Status::done) keep();
      if (transfer_.status() != SdoTransfer::Status::waiting && ++place_ < std::size(kQuestions)) next = ask();
    }
  }
  bool found() const noexcept { return heard_ || found_.state; }
  const FoundNode& node() const noexcept { return found_; }

 private:
  void keep() {
    const Object object = kQuestions[place_];
    if (object == kDeviceName) {
      found_.name = to_text(transfer_.value(), DataType::visible_string);
      return;
    }
    std::optional<std::uint32_t>& number = object == kDeviceType ? found_.device_type
                                           : object == kVendor   ? found_.vendor
                                           : object == kProduct  ? found_.product
                                           : object == kRevision ? found_.revision
                                                                 : found_.serial;
    number = static_cast<std::uint32_t>(can::get(transfer_.value(), 0, 4));
  }

  SdoTransfer transfer_;
  std::size_t place_ = 0;
  bool heard_ = false;
  FoundNode found_;
};

std::string profile_text(const FoundNode& node) {
  if (!node.device_type) return "no answer";
  const unsigned profile = *node.device_type & 0xffff;
  return std::to_string(profile) + (profile == 402 ? " (drive)" : profile == 401 ? " (I/O)" : "");
}

std::string number_text(const std::optional<std::uint32_t>& number) {
  return number ? fmt::format("0x{:x}", *number) : "-";
}

}  // namespace

ScanResult scan(can::Bus& bus, std::int64_t patience) {
  bus.filter(std::array{can::Filter{kSdoResponse, 0x780}, can::Filter{kHeartbeat, 0x780}});
  ScanResult result;
  std::deque<Inquiry> inquiries;
  std::deque<can::Frame> to_send;
  for (unsigned node = 1; node <= kMaxNode; ++node)
    to_send.push_back(inquiries.emplace_back(static_cast<NodeId>(node)).ask());
  std::int64_t deadline = clock::monotonic_ns() + patience;
  for (std::int64_t now = clock::monotonic_ns(); now < deadline; now = clock::monotonic_ns()) {
    while (!to_send.empty() && result.error != can::BusError::down) {
      const can::Sent sent = bus.send(to_send.front());
      if (sent == can::Sent::down) result.error = can::BusError::down;
      if (sent != can::Sent::yes) break;
      to_send.pop_front();
      deadline = now + patience;
    }
    if (result.error == can::BusError::down) break;
    can::Frame frame;
    const std::int64_t until = to_send.empty() ? deadline : std::min(deadline, now + kRetry);
    if (!bus.receive(frame, until)) {
      if (clock::monotonic_ns() < until) result.error = can::BusError::down;  // the bus is gone
      continue;
    }
    if (frame.error) {
      result.error = can::bus_error_of(frame);
    } else if (const unsigned node = frame.id & 0x7f; node != 0) {
      can::Frame next;
      inquiries[node - 1].take(frame, next);
      if (next.id != 0) to_send.push_back(next);
    }
  }
  if (!to_send.empty() && result.error == can::BusError::none) result.error = can::BusError::queue_full;
  for (const Inquiry& inquiry : inquiries)
    if (inquiry.found()) result.nodes.push_back(inquiry.node());
  return result;
}

std::string scan_text(const std::vector<FoundNode>& nodes) {
  std::vector<std::array<std::string, 8>> rows{
      {"node", "state", "profile", "name", "vendor", "product", "revision", "serial number"}};
  for (const FoundNode& node : nodes)
    rows.push_back({std::to_string(node.node), node.state ? std::string(describe(*node.state)) : "no heartbeat",
                    profile_text(node), node.name.empty() ? "-" : node.name, number_text(node.vendor),
                    number_text(node.product), number_text(node.revision), number_text(node.serial)});
  std::array<std::size_t, 8> widths{};
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) text += fmt::format("{:<{}}  ", row[i], widths[i]);
    text.append(row.back()).append("\n");
  }
  return text;
}

std::string silence_text(const std::string& interface, can::BusError error, double patience) {
  std::string text = fmt::format("{}: no node has answered within {:g} s", interface, patience);
  if (error != can::BusError::none) text += fmt::format("; the bus: {}", can::describe(error));
  return text + fmt::format(R"(
Look at
  the drives' power, and their node numbers: 1 to 127, each its own
  the bit rate, the same of all: ip -details link show {0}
  the wires: CAN_H to CAN_H, CAN_L to CAN_L, ground; 120 ohm at both ends, 60 ohm between the wires without power
  the errors that the controller counts: ip -statistics link show {0}
)",
                            interface);
}

}  // namespace mrroc::cli
