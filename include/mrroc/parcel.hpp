#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mrroc/fixed_text.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

/// A serialised message between the programs of an MP and its ECPs: `pack` makes it from a type declared with
/// MRROC_MESSAGE, `unpack` restores the type. Fixed size: copying it never allocates.
struct Message {
  static constexpr std::size_t kCapacity = 512;

  FixedText<kNameLength> label;                   ///< the type's name; empty without a message
  std::uint64_t fingerprint = 0;                  ///< of the label and of every field's name, kind and size
  std::uint16_t size = 0;                         ///< bytes of `content` in use
  std::array<std::uint8_t, kCapacity> content{};  ///< the fields in order
};

}  // namespace mrroc
