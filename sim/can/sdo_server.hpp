#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "can/frame.hpp"
#include "sim/can/object_store.hpp"

namespace mrroc::sim {

/// A simulated node's answers to SDO requests (CiA 301, 7.2.4): expedited transfers and, for strings, uploads in
/// segments. One thread.
class SdoServer {
 public:
  SdoServer(canopen::NodeId node, ObjectStore& store) : node_(node), store_(store) {}

  /// The answer to a frame; nothing when it is not a request to this node, or is an abort.
  std::optional<can::Frame> answer(const can::Frame& request);

  /// The node has restarted: a transfer under way is forgotten.
  void reset() noexcept { uploading_ = false; }

 private:
  can::Frame abort(const can::Frame& request, canopen::SdoAbort why) const;
  can::Frame upload(const can::Frame& request);
  can::Frame upload_segment(const can::Frame& request);
  can::Frame download(const can::Frame& request);

  canopen::NodeId node_;
  ObjectStore& store_;
  std::vector<std::uint8_t> value_;  ///< that is being uploaded in segments
  std::size_t sent_ = 0;
  std::uint8_t toggle_ = 0;
  bool uploading_ = false;
};

}  // namespace mrroc::sim
