#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "can/frame.hpp"
#include "canopen/objects.hpp"

namespace mrroc::test {

/// An SDO server written from CiA 301, 7.2.4.3, alone: transfers one value, expedited or in segments, in both
/// directions. It refuses other requests and checks its client's toggle bit.
class PlainServer {
 public:
  explicit PlainServer(std::uint8_t node) : node_(node) {}

  std::map<canopen::Object, std::vector<std::uint8_t>> values;
  bool tells_size = true;      ///< in the answers to uploads
  bool spoils_toggle = false;  ///< in its segments

  std::optional<can::Frame> answer(const can::Frame& request) {
    if (request.id != 0x600u + node_ || request.size != 8) return {};
    const unsigned command = request.data[0] >> 5;
    if (command == 0 || command == 3) return command == 0 ? write_segment(request) : read_segment(request);
    object_ = {static_cast<std::uint16_t>(request.data[1] | request.data[2] << 8), request.data[3]};
    toggle_ = 0;
    if (command == 1) return write(request);
    if (command == 2) return read();
    return {};  // an abort
  }

 private:
  can::Frame reply(unsigned command) const {
    return {0x580u + node_,
            {static_cast<std::uint8_t>(command), static_cast<std::uint8_t>(object_.index & 0xff),
             static_cast<std::uint8_t>(object_.index >> 8), object_.sub, 0, 0, 0, 0}};
  }
  can::Frame abort(std::uint32_t code) const {
    can::Frame frame = reply(0x80);
    for (std::size_t i = 0; i < 4; ++i) frame.data[4 + i] = static_cast<std::uint8_t>(code >> 8 * i);
    return frame;
  }
  can::Frame read() {
    if (!values.contains(object_)) return abort(0x06020000);
    const std::vector<std::uint8_t>& value = values[object_];
    at_ = 0;
    if (value.empty() || value.size() > 4) {
      can::Frame frame = reply(tells_size ? 0x41 : 0x40);
      if (tells_size) frame.data[4] = static_cast<std::uint8_t>(value.size());
      return frame;
    }
    const bool size = tells_size || value.size() < 4;
    can::Frame frame = reply(static_cast<unsigned>(0x42 | (size ? 1 | (4 - value.size()) << 2 : 0)));
    std::copy(value.begin(), value.end(), frame.data.begin() + 4);
    return frame;
  }
  can::Frame read_segment(const can::Frame& request) {
    if ((request.data[0] & 0x10) != toggle_) return abort(0x05030000);
    const std::vector<std::uint8_t>& value = values[object_];
    const std::size_t count = std::min<std::size_t>(7, value.size() - at_);
    const bool last = at_ + count == value.size();
    can::Frame frame{0x580u + node_, {0, 0, 0, 0, 0, 0, 0, 0}};
    frame.data[0] = static_cast<std::uint8_t>((spoils_toggle ? toggle_ ^ 0x10 : toggle_) | (7 - count) << 1 | last);
    std::copy_n(value.begin() + static_cast<std::ptrdiff_t>(at_), count, frame.data.begin() + 1);
    at_ += count;
    toggle_ ^= 0x10;
    return frame;
  }
  can::Frame write(const can::Frame& request) {
    if (!values.contains(object_)) return abort(0x06020000);
    if ((request.data[0] & 2) == 0) {
      announced_ = request.data[4];
      values[object_].clear();
      return reply(0x60);
    }
    const std::size_t count = (request.data[0] & 1) != 0 ? 4u - (request.data[0] >> 2 & 3u) : 4u;
    values[object_].assign(request.data.begin() + 4, request.data.begin() + 4 + static_cast<std::ptrdiff_t>(count));
    return reply(0x60);
  }
  can::Frame write_segment(const can::Frame& request) {
    if ((request.data[0] & 0x10) != toggle_) return abort(0x05030000);
    const auto count = static_cast<std::ptrdiff_t>(7 - (request.data[0] >> 1 & 7));
    std::vector<std::uint8_t>& value = values[object_];
    value.insert(value.end(), request.data.begin() + 1, request.data.begin() + 1 + count);
    if ((request.data[0] & 1) != 0 && value.size() != announced_) return abort(0x06070010);
    const can::Frame frame{
        0x580u + node_,
        {static_cast<std::uint8_t>(0x20 | (spoils_toggle ? toggle_ ^ 0x10 : toggle_)), 0, 0, 0, 0, 0, 0, 0}};
    toggle_ ^= 0x10;
    return frame;
  }

  std::uint8_t node_;
  canopen::Object object_;
  std::size_t at_ = 0, announced_ = 0;
  int toggle_ = 0;
};

}  // namespace mrroc::test
