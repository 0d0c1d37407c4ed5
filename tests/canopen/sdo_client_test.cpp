#include "canopen/sdo_client.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "canopen/plain_server.hpp"
#include "clock/wall/monotonic.hpp"

namespace mrroc::canopen {
namespace {

/// A bus with one node that answers at once.
class AnsweringBus : public can::Bus {
 public:
  explicit AnsweringBus(test::PlainServer& server) : server_(server) {}
  bool babbles = false;  ///< another node always sends one more frame
  bool takes = true;

  can::Sent send(const can::Frame& frame) noexcept override {
    if (!takes) return can::Sent::full;
    if (const auto answer = server_.answer(frame)) frames_.push_back(*answer);
    return can::Sent::yes;
  }
  bool receive(can::Frame& frame, std::int64_t) noexcept override {
    if (frames_.empty() && !babbles) return false;
    frame = frames_.empty() ? can::Frame{0x111, {1}} : frames_.front();
    if (!frames_.empty()) frames_.pop_front();
    return true;
  }
  void filter(std::span<const can::Filter>) override {}
  bool carries_fd() const noexcept override { return false; }
  int descriptor() const noexcept override { return -1; }
  void push(const can::Frame& frame) { frames_.push_back(frame); }

 private:
  test::PlainServer& server_;
  std::deque<can::Frame> frames_;
};

constexpr NodeId kNode = 7;
constexpr std::int64_t kPatience = clock::kSecond / 100;

template <class Action>
std::string refusal(Action&& action, SdoAbort& abort) {
  try {
    action();
  } catch (const SdoError& error) {
    abort = error.abort();
    return error.what();
  }
  return "";
}

TEST(SdoClient, ReadsAndWritesAndPassesOtherFramesOn) {
  test::PlainServer server(kNode);
  server.values[kMode] = {0};
  server.values[kDeviceName] = {'s', 'e', 'r', 'v', 'o'};
  AnsweringBus bus(server);
  std::vector<std::uint32_t> others;
  SdoClient client(bus, kPatience, [&others](const can::Frame& frame) { others.push_back(frame.id); });
  client.download(kNode, kMode, 8, 1);
  EXPECT_EQ(server.values[kMode], std::vector<std::uint8_t>{8});
  bus.push({0x707, {5}});
  EXPECT_EQ(client.upload(kNode, kDeviceName), server.values[kDeviceName]);
  EXPECT_EQ(others, std::vector<std::uint32_t>{0x707});
}

TEST(SdoClient, ReportsNodeAndObjectOfAFailure) {
  test::PlainServer server(kNode);
  AnsweringBus bus(server);
  SdoClient client(bus, kPatience);
  SdoAbort abort{};
  EXPECT_EQ(refusal([&] { client.upload(kNode, kVendor); }, abort),
            "node 7, object 1018h:1: object does not exist in the object dictionary");
  EXPECT_EQ(abort, SdoAbort::no_such_object);
  EXPECT_EQ(refusal([&] { client.upload(8, kVendor); }, abort), "node 8, object 1018h:1: SDO protocol timed out");
  bus.takes = false;
  EXPECT_NE(refusal([&] { client.upload(kNode, kVendor); }, abort), "");
  EXPECT_EQ(abort, SdoAbort::timeout);
}

TEST(SdoClient, BabblingNodeDoesNotBlockIt) {
  test::PlainServer server(kNode);
  AnsweringBus bus(server);
  bus.babbles = true;
  SdoClient client(bus, kPatience);
  SdoAbort abort{};
  EXPECT_NE(refusal([&] { client.upload(8, kVendor); }, abort), "");
  EXPECT_EQ(abort, SdoAbort::timeout);
}

}  // namespace
}  // namespace mrroc::canopen
