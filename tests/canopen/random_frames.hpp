#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <vector>

#include "can/frame.hpp"
#include "canopen/objects.hpp"

namespace rc {

template <>
struct Arbitrary<mrroc::canopen::Object> {
  static Gen<mrroc::canopen::Object> arbitrary() {
    return gen::construct<mrroc::canopen::Object>(gen::arbitrary<std::uint16_t>(), gen::arbitrary<std::uint8_t>());
  }
};

/// Any frame of a bus; one in four is of CAN FD.
template <>
struct Arbitrary<mrroc::can::Frame> {
  static Gen<mrroc::can::Frame> arbitrary() {
    return gen::exec([] {
      mrroc::can::Frame frame;
      frame.fd = *gen::inRange(0, 4) == 0;
      frame.error = *gen::inRange(0, 8) == 0;
      frame.remote = !frame.fd && *gen::inRange(0, 8) == 0;
      frame.id = *gen::inRange<std::uint32_t>(0, 0x800);
      const auto most = frame.fd ? mrroc::can::kMaxData : mrroc::can::kMaxClassicalData;
      frame.size = *gen::inRange<std::uint8_t>(0, static_cast<std::uint8_t>(most + 1));
      const auto bytes = *gen::container<std::vector<std::uint8_t>>(frame.size, gen::arbitrary<std::uint8_t>());
      std::copy(bytes.begin(), bytes.end(), frame.data.begin());
      return frame;
    });
  }
};

}  // namespace rc

namespace mrroc::test {

/// A value of up to `most` bytes; all lengths are equally likely.
inline std::vector<std::uint8_t> random_value(std::size_t least, std::size_t most) {
  const auto size = *rc::gen::inRange(least, most + 1);
  return *rc::gen::container<std::vector<std::uint8_t>>(size, rc::gen::arbitrary<std::uint8_t>());
}

}  // namespace mrroc::test
