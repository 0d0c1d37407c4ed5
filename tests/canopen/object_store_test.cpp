#include "sim/can/object_store.hpp"

#include <gtest/gtest.h>

#include <array>

#include "can/frame.hpp"

namespace mrroc::sim {
namespace {

using namespace canopen;

constexpr Object kIdentifier{0x1400, 1};

class ObjectStoreTest : public testing::Test {
 protected:
  SdoAbort write(Object object, std::uint64_t value) {
    std::array<std::uint8_t, 8> bytes{};
    can::put(bytes, 0, bytes.size(), value);
    return store.write(object, std::span(bytes).first(store.size(object)));
  }
  ObjectStore store{EdsFile::load(std::filesystem::path(MRROC_SOURCE_DIR) / "src/canopen/cia402.eds"), 3};
};

TEST_F(ObjectStoreTest, PdoInUseCannotBeChanged) {
  ASSERT_EQ(write(kIdentifier, 0x203), SdoAbort::none) << "unchanged";
  EXPECT_EQ(write(kIdentifier, 0x333), SdoAbort::invalid_value);
  EXPECT_EQ(write({0x1600, 0}, 0), SdoAbort::wrong_state);
  EXPECT_EQ(write({0x1600, 1}, 0x60400010), SdoAbort::wrong_state);
  EXPECT_EQ(write(kIdentifier, 0x80000203), SdoAbort::none);
  EXPECT_EQ(write(kIdentifier, 0x80000333), SdoAbort::none);
  EXPECT_EQ(write({0x1600, 0}, 0), SdoAbort::none);
  EXPECT_EQ(write(kIdentifier, 0x203), SdoAbort::none);
}

TEST_F(ObjectStoreTest, ObjectsAreMappedWhileTheirNumberIsZero) {
  ASSERT_EQ(write(kIdentifier, 0x80000203), SdoAbort::none);
  ASSERT_NE(store.number({0x1600, 0}), 0);
  EXPECT_EQ(write({0x1600, 1}, 0x60400010), SdoAbort::unsupported_access);
  ASSERT_EQ(write({0x1600, 0}, 0), SdoAbort::none);
  EXPECT_EQ(write({0x1600, 1}, 0x60400010), SdoAbort::none);
  EXPECT_EQ(write({0x1600, 2}, 0x607a0020), SdoAbort::none);
  EXPECT_EQ(write({0x1600, 3}, 0x60ff0020), SdoAbort::none);
  EXPECT_EQ(write({0x1600, 0}, 3), SdoAbort::mapping_too_long) << "10 bytes";
  EXPECT_EQ(write({0x1600, 0}, 65), SdoAbort::mapping_too_long) << "more than there are bits";
  EXPECT_EQ(write({0x1600, 0}, 2), SdoAbort::none);
}

TEST_F(ObjectStoreTest, MapsOnlyObjectsThatAPdoMayCarry) {
  for (const std::uint16_t parameters : {kReceivePdoParameters, kTransmitPdoParameters}) {
    ASSERT_EQ(write({parameters, 1}, 0x80000000 | static_cast<std::uint64_t>(store.number({parameters, 1}))),
              SdoAbort::none);
    ASSERT_EQ(write({static_cast<std::uint16_t>(parameters + 0x200), 0}, 0), SdoAbort::none);
  }
  EXPECT_EQ(write({0x1600, 1}, 0x70000010), SdoAbort::not_mappable) << "the object does not exist";
  EXPECT_EQ(write({0x1600, 1}, 0x60400020), SdoAbort::not_mappable) << "it has 16 bits";
  EXPECT_EQ(write({0x1600, 1}, 0x60410010), SdoAbort::not_mappable) << "it may only be read";
  EXPECT_EQ(write({0x1a00, 1}, 0x60410010), SdoAbort::none);
  EXPECT_EQ(write({0x1a00, 1}, 0x10000020), SdoAbort::not_mappable) << "the device type";
}

}  // namespace
}  // namespace mrroc::sim
