#include "canopen/sdo_client.hpp"

#include <array>

#include "canopen/object_value.hpp"
#include "clock/wall/monotonic.hpp"

namespace mrroc::canopen {

SdoError::SdoError(NodeId node, Object object, SdoAbort abort)
    : std::runtime_error("node " + std::to_string(node) + ", object " + to_text(object) + ": " +
                         std::string(describe(abort))),
      abort_(abort) {}

SdoClient::SdoClient(can::Bus& bus, std::int64_t patience, std::function<void(const can::Frame&)> others)
    : bus_(bus), patience_(patience), others_(std::move(others)) {}

std::vector<std::uint8_t> SdoClient::upload(NodeId node, Object object) {
  finish(transfer_.upload(node, object));
  return {transfer_.value().begin(), transfer_.value().end()};
}

void SdoClient::download(NodeId node, Object object, std::span<const std::uint8_t> value) {
  finish(transfer_.download(node, object, value));
}

void SdoClient::download(NodeId node, Object object, std::uint64_t value, std::size_t size) {
  std::array<std::uint8_t, 8> bytes{};
  can::put(bytes, 0, size, value);
  download(node, object, std::span(bytes).first(size));
}

void SdoClient::finish(can::Frame request) {
  std::int64_t deadline = clock::monotonic_ns() + patience_;
  bool sent = bus_.send(request) == can::Sent::yes;
  while (transfer_.status() == SdoTransfer::Status::waiting) {
    can::Frame frame;
    if (!sent || !bus_.receive(frame, deadline))
      throw SdoError(transfer_.node(), transfer_.object(), SdoAbort::timeout);
    can::Frame next;
    if (!transfer_.take(frame, next)) {
      if (others_) others_(frame);
      sent = sent && clock::monotonic_ns() < deadline;  // also while other nodes send many frames
    } else if (next.id != 0) {
      sent = bus_.send(next) == can::Sent::yes;
      deadline = clock::monotonic_ns() + patience_;
    }
  }
  if (transfer_.status() == SdoTransfer::Status::refused)
    throw SdoError(transfer_.node(), transfer_.object(), transfer_.abort());
}

}  // namespace mrroc::canopen
