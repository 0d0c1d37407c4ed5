#include "sim/can/sdo_server.hpp"

#include <gtest/gtest.h>

#include "canopen/random_frames.hpp"
#include "canopen/sdo.hpp"

namespace mrroc::sim {
namespace {

using namespace canopen;
using Status = SdoTransfer::Status;

constexpr NodeId kNode = 9;

const EdsFile& standard_eds() {
  static const EdsFile file = EdsFile::load(std::filesystem::path(MRROC_SOURCE_DIR) / "src/canopen/cia402.eds");
  return file;
}

/// A node's store and its server.
struct Node {
  ObjectStore store{standard_eds(), kNode};
  SdoServer server{kNode, store};

  void carry(SdoTransfer& transfer, can::Frame frame) {
    for (int i = 0; i < 100 && transfer.status() == Status::waiting; ++i)
      if (const auto answer = server.answer(frame)) transfer.take(*answer, frame);
  }
  SdoTransfer upload(Object object) {
    SdoTransfer transfer;
    carry(transfer, transfer.upload(kNode, object));
    return transfer;
  }
  SdoTransfer download(Object object, std::span<const std::uint8_t> value) {
    SdoTransfer transfer;
    carry(transfer, transfer.download(kNode, object, value));
    return transfer;
  }
};

TEST(SdoServer, SendsItsNameInSegments) {
  Node node;
  const SdoTransfer transfer = node.upload(kDeviceName);
  ASSERT_EQ(transfer.status(), Status::done);
  EXPECT_EQ(std::string(transfer.value().begin(), transfer.value().end()), "CiA 402 servo drive");
}

TEST(SdoServer, HasEveryObjectOfItsFile) {
  Node node;
  for (const auto& [object, entry] : standard_eds().entries()) {
    const SdoTransfer transfer = node.upload(object);
    EXPECT_EQ(transfer.status(), entry.readable() ? Status::done : Status::refused) << entry.name;
    if (const std::size_t size = size_of(entry.type); size != 0 && entry.readable()) {
      EXPECT_EQ(transfer.value().size(), size) << entry.name;
    }
  }
}

TEST(SdoServer, ReadsWhatWasWritten) {
  std::vector<Object> writable;
  const auto is_of_pdo = [](Object object) { return object.index >= 0x1400 && object.index < 0x1c00; };
  for (const auto& [object, entry] : standard_eds().entries())
    if (!is_of_pdo(object) && entry.writable() && size_of(entry.type) != 0 && size_of(entry.type) <= 4)
      writable.push_back(object);
  Node node;
  EXPECT_TRUE(rc::check("a value of the object's size", [&] {
    const Object object = *rc::gen::elementOf(writable);
    const auto value = test::random_value(node.store.size(object), node.store.size(object));
    RC_ASSERT(node.download(object, value).status() == Status::done);
    const SdoTransfer read = node.upload(object);
    RC_ASSERT(std::vector<std::uint8_t>(read.value().begin(), read.value().end()) == value);
  }));
}

TEST(SdoServer, RefusesWithTheCodesOfTheStandard) {
  Node node;
  const std::vector<std::uint8_t> four(4), two(2);
  EXPECT_EQ(node.upload({0x2345, 0}).abort(), SdoAbort::no_such_object);
  EXPECT_EQ(node.upload({0x1018, 9}).abort(), SdoAbort::no_such_sub_index);
  EXPECT_EQ(node.download(kStatusword, two).abort(), SdoAbort::read_only);
  EXPECT_EQ(node.download(kControlword, four).abort(), SdoAbort::wrong_length);
  EXPECT_EQ(node.download(kControlword, std::vector<std::uint8_t>(9)).status(), Status::refused);
}

TEST(SdoServer, AnswersOnlyRequestsToItself) {
  Node node;
  EXPECT_TRUE(rc::check("any frames", [&](can::Frame frame) {
    if (*rc::gen::arbitrary<bool>()) frame.id = kSdoRequest + kNode;
    const auto answer = node.server.answer(frame);
    if (!answer) return;
    RC_ASSERT(frame.id == kSdoRequest + kNode && frame.size == 8 && !frame.error && !frame.remote);
    RC_ASSERT(answer->id == kSdoResponse + kNode && answer->size == 8);
  }));
}

}  // namespace
}  // namespace mrroc::sim
