#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "can/frame.hpp"
#include "canopen/identifiers.hpp"
#include "canopen/objects.hpp"

namespace mrroc::canopen {

/// Maximum bytes of one value: names and versions of devices are the longest values read.
inline constexpr std::size_t kMaxValue = 128;

/// The reason why a transfer was refused (CiA 301, table 22); `timeout` also when no answer arrived.
enum class SdoAbort : std::uint32_t {
  none = 0,
  toggle_bit = 0x05030000,
  timeout = 0x05040000,
  unknown_command = 0x05040001,
  out_of_memory = 0x05040005,
  unsupported_access = 0x06010000,
  write_only = 0x06010001,
  read_only = 0x06010002,
  no_such_object = 0x06020000,
  not_mappable = 0x06040041,
  mapping_too_long = 0x06040042,
  wrong_length = 0x06070010,
  no_such_sub_index = 0x06090011,
  invalid_value = 0x06090030,
  wrong_state = 0x08000022
};

/// The standard's text of an abort code; "unknown abort code" for other codes.
std::string_view describe(SdoAbort abort) noexcept;

/// The client's side of one transfer of a value (CiA 301, 7.2.4), expedited or in segments. It sends nothing itself and
/// has no clock: its owner sends its requests, passes the received frames to it, and detects timeouts. Allocates
/// nothing, never throws. One thread.
class SdoTransfer {
 public:
  enum class Status : std::uint8_t { idle, waiting, done, refused };

  /// Begins to read `object` of `node`; returns the request.
  can::Frame upload(NodeId node, Object object) noexcept;
  /// Begins to write; at most kMaxValue bytes, longer values are cut.
  can::Frame download(NodeId node, Object object, std::span<const std::uint8_t> value) noexcept;

  /// Processes a frame of the bus. True: it was an answer of this transfer, and `next` must be sent if its identifier
  /// is not 0.
  bool take(const can::Frame& frame, can::Frame& next) noexcept;

  Status status() const noexcept { return status_; }
  SdoAbort abort() const noexcept { return abort_; }
  /// The value read.
  std::span<const std::uint8_t> value() const noexcept { return {value_.data(), size_}; }
  NodeId node() const noexcept { return node_; }
  Object object() const noexcept { return object_; }

 private:
  can::Frame request(std::uint8_t command) const noexcept;
  can::Frame refuse(SdoAbort why) noexcept;
  can::Frame take_upload(const can::Frame& frame) noexcept;
  can::Frame take_segment(const can::Frame& frame) noexcept;
  can::Frame next_segment() noexcept;

  Status status_ = Status::idle;
  bool writes_ = false;
  bool segmented_ = false;
  bool begun_ = false;  ///< the first request has been answered: segments follow
  std::uint8_t toggle_ = 0;
  NodeId node_ = 0;
  Object object_;
  SdoAbort abort_ = SdoAbort::none;
  std::array<std::uint8_t, kMaxValue> value_{};
  std::size_t size_ = 0;  ///< of value_ in use
  std::size_t sent_ = 0;
  std::size_t told_ = 0;  ///< the size that the server has announced; above kMaxValue: not announced
};

}  // namespace mrroc::canopen
