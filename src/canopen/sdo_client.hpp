#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <vector>

#include "can/bus.hpp"
#include "canopen/sdo.hpp"

namespace mrroc::canopen {

/// A transfer that failed: "node 3, object 6040h:0: <the abort's text>".
class SdoError : public std::runtime_error {
 public:
  SdoError(NodeId node, Object object, SdoAbort abort);
  SdoAbort abort() const noexcept { return abort_; }

 private:
  SdoAbort abort_;
};

/// Reads and writes values of nodes, one after the other, waiting for each answer. For start-up and tools; one thread.
class SdoClient {
 public:
  /// `patience`: timeout of an answer, ns. `others` is called with every frame that does not belong to a transfer.
  /// `bus` must outlive it.
  SdoClient(can::Bus& bus, std::int64_t patience, std::function<void(const can::Frame&)> others = {});

  /// The value that the node returns, at most kMaxValue bytes. Throws SdoError: refused, or no answer (`timeout`).
  std::vector<std::uint8_t> upload(NodeId node, Object object);
  /// Throws SdoError.
  void download(NodeId node, Object object, std::span<const std::uint8_t> value);
  /// The number in the lowest `size` bytes (1..8) of `value`.
  void download(NodeId node, Object object, std::uint64_t value, std::size_t size);

 private:
  void finish(can::Frame request);

  can::Bus& bus_;
  std::int64_t patience_;
  std::function<void(const can::Frame&)> others_;
  SdoTransfer transfer_;
};

}  // namespace mrroc::canopen
