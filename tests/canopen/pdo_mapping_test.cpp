#include "canopen/pdo_mapping.hpp"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

#include "canopen/random_frames.hpp"

namespace mrroc::canopen {
namespace {

/// Distinct objects that fill up to 8 bytes.
std::vector<MappedObject> random_objects() {
  std::vector<MappedObject> objects;
  std::size_t left = can::kMaxClassicalData;
  for (std::uint8_t i = 0; left > 0 && *rc::gen::inRange(0, 6) > 0; ++i) {
    const auto size = *rc::gen::inRange<std::size_t>(1, left + 1);
    objects.push_back({{static_cast<std::uint16_t>(0x6000 + i), i}, static_cast<std::uint8_t>(size)});
    left -= size;
  }
  return objects;
}

std::string refusal(std::vector<MappedObject> objects) {
  try {
    const PdoMapping mapping(std::move(objects));
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(PdoMapping, ReadsWhatItWrites) {
  EXPECT_TRUE(rc::check("every value at its position, with its sign", [] {
    const PdoMapping mapping(random_objects());
    can::Frame frame{0x200, {}};
    std::map<Object, std::int64_t> written;
    for (const MappedObject& mapped : mapping.objects()) {
      const auto raw = *rc::gen::arbitrary<std::uint64_t>();
      written[mapped.object] = can::sign_extended(raw, mapped.size);
      mapping.write(frame, mapped.object, written[mapped.object]);
    }
    if (!written.empty()) RC_ASSERT(frame.size == mapping.size());
    for (const auto& [object, value] : written) {
      std::int64_t read = 0;
      RC_ASSERT(mapping.read(frame, object, true, read));
      RC_ASSERT(read == value);
    }
    std::int64_t none = 0;
    RC_ASSERT(!mapping.read(frame, {0x1000}, true, none));
  }));
}

TEST(PdoMapping, ShortFrameHasNoValue) {
  EXPECT_TRUE(rc::check("any size", [](can::Frame frame) {
    const PdoMapping mapping(random_objects());
    std::size_t end = 0;
    for (const MappedObject& mapped : mapping.objects()) {
      end += mapped.size;
      std::int64_t value = 0;
      RC_ASSERT(mapping.read(frame, mapped.object, false, value) == (!frame.fd && end <= frame.size));
    }
  }));
}

TEST(PdoMapping, RoundTripsItsEntries) {
  EXPECT_TRUE(rc::check("1600h..", [](Object object) {
    const MappedObject mapped{object, *rc::gen::inRange<std::uint8_t>(1, 9)};
    RC_ASSERT(MappedObject::of_entry(mapped.entry()) == mapped);
  }));
  EXPECT_EQ((MappedObject{{0x6040, 0}, 2}.entry()), 0x60400010u);
  EXPECT_EQ(MappedObject::of_entry(0x60fd0001).size, 0) << "a single bit";
}

TEST(PdoMapping, RefusesUnmappableObjects) {
  EXPECT_EQ(refusal({{{0x6040, 0}, 0}}), "object 6040h:0: 0 bytes in a PDO, expected 1 to 8");
  EXPECT_EQ(refusal({{{0x6040, 0}, 9}}), "object 6040h:0: 9 bytes in a PDO, expected 1 to 8");
  EXPECT_EQ(refusal({{{0x6064, 0}, 4}, {{0x606c, 0}, 4}, {{0x6077, 0}, 2}}), "10 bytes in a PDO, expected at most 8");
}

}  // namespace
}  // namespace mrroc::canopen
