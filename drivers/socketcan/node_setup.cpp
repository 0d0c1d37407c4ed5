#include "drivers/socketcan/node_setup.hpp"

#include <algorithm>
#include <array>

namespace mrroc::edp {

using namespace canopen;

NodeSetup::NodeSetup(NodeId node, std::vector<config::NodeSetting> settings)
    : node_(node), settings_(std::move(settings)) {}

can::Frame NodeSetup::start() noexcept {
  place_ = 0;
  status_ = Status::writing;
  looks_ = forgotten_ = false;
  return request();
}

can::Frame NodeSetup::resume() noexcept {
  place_ = 0;
  status_ = Status::writing;
  looks_ = true;
  forgotten_ = false;
  return poll();
}

can::Frame NodeSetup::poll() noexcept { return transfer_.upload(node_, kProducerHeartbeat); }

can::Frame NodeSetup::request() noexcept {
  std::array<std::uint8_t, 8> bytes{};
  can::put(bytes, 0, bytes.size(), static_cast<std::uint64_t>(setting().value));
  return transfer_.download(node_, setting().object, std::span(bytes).first(setting().size));
}

bool NodeSetup::take(const can::Frame& frame, can::Frame& next) noexcept {
  if (status_ != Status::writing || !transfer_.take(frame, next)) return false;
  if (looks_) {
    if (transfer_.status() == SdoTransfer::Status::waiting) return true;
    const auto beat = [](const config::NodeSetting& setting) { return setting.object == kProducerHeartbeat; };
    const auto ours = std::find_if(settings_.begin(), settings_.end(), beat);
    forgotten_ = transfer_.status() != SdoTransfer::Status::done || ours == settings_.end() ||
                 static_cast<std::int64_t>(can::get(transfer_.value(), 0, 2)) != ours->value;
    looks_ = false;
    next = request();
  } else if (transfer_.status() == SdoTransfer::Status::refused) {
    status_ = Status::refused;
  } else if (transfer_.status() == SdoTransfer::Status::done) {
    if (place_ + 1 == settings_.size()) {
      status_ = Status::done;
    } else {
      ++place_;
      next = request();
    }
  }
  return true;
}

}  // namespace mrroc::edp
