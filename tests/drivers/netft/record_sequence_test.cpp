#include "drivers/netft/record_sequence.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <vector>

namespace mrroc::netft::record_sequence_test {
namespace {

std::vector<Place> places(RecordSequence& sequence, const std::vector<std::uint32_t>& numbers) {
  std::vector<Place> found;
  for (const std::uint32_t number : numbers) found.push_back(sequence.add(number));
  return found;
}

TEST(RecordSequence, CountsLostRecords) {
  RecordSequence sequence;
  EXPECT_EQ(places(sequence, {1, 2, 5}), (std::vector{Place::newest, Place::newest, Place::newest}));
  EXPECT_EQ(sequence.lost(), 2u);
}

TEST(RecordSequence, LateRecordIsNotLost) {
  RecordSequence sequence;
  EXPECT_EQ(places(sequence, {1, 3, 2}), (std::vector{Place::newest, Place::newest, Place::late}));
  EXPECT_EQ(sequence.lost(), 0u);
  EXPECT_EQ(sequence.late(), 1u);
}

TEST(RecordSequence, DoubledRecordIsCountedOnce) {
  RecordSequence sequence;
  EXPECT_EQ(places(sequence, {1, 2, 2, 1}),
            (std::vector{Place::newest, Place::newest, Place::doubled, Place::doubled}));
  EXPECT_EQ(sequence.doubled(), 2u);
  EXPECT_EQ(sequence.lost(), 0u);
}

TEST(RecordSequence, WrapsAround) {
  RecordSequence sequence;
  EXPECT_EQ(places(sequence, {0xffff'fffe, 1, 0xffff'ffff, 0, 0}),
            (std::vector{Place::newest, Place::newest, Place::late, Place::late, Place::doubled}));
  EXPECT_EQ(sequence.lost(), 0u);
  EXPECT_EQ(sequence.restarts(), 0u);
}

TEST(RecordSequence, RestartIsNotLoss) {
  RecordSequence sequence;
  EXPECT_EQ(places(sequence, {1000, 1, 2}), (std::vector{Place::newest, Place::restarted, Place::newest}));
  EXPECT_EQ(sequence.lost(), 0u);
  EXPECT_EQ(sequence.restarts(), 1u);
  EXPECT_EQ(sequence.add(2 + RecordSequence::kMaxGap + 1), Place::restarted);
}

TEST(RecordSequence, RecordFromBeforeTheFirstOneWasNotCountedAsLost) {
  RecordSequence sequence;
  EXPECT_EQ(places(sequence, {10, 9}), (std::vector{Place::newest, Place::late}));
  EXPECT_EQ(sequence.lost(), 0u);
}

TEST(RecordSequence, RenewedStreamBeginsAnywhere) {
  RecordSequence sequence;
  sequence.add(10);
  sequence.renew();
  EXPECT_EQ(places(sequence, {1, 2}), (std::vector{Place::newest, Place::newest}));
  EXPECT_EQ(sequence.restarts(), 0u);
  EXPECT_EQ(sequence.lost(), 0u);
}

/// A network that loses, doubles and delays the records of one stream by fewer than kWindow places.
std::vector<std::uint32_t> through_a_network(std::uint32_t first) {
  struct Sent {
    std::uint32_t number;
    std::size_t arrival;
  };
  std::vector<Sent> sent;
  const auto count = *rc::gen::inRange<std::uint32_t>(1, 300);
  for (std::uint32_t i = 0; i < count; ++i) {
    const int copies = *rc::gen::weightedElement<int>({{2, 0}, {20, 1}, {2, 2}, {1, 3}});
    for (int copy = 0; copy < copies; ++copy) {
      const auto delay = *rc::gen::weightedElement<std::size_t>({{10, 0}, {1, 1}, {1, 7}, {1, 30}});
      sent.push_back({first + i, i + delay});
    }
  }
  std::stable_sort(sent.begin(), sent.end(), [](const Sent& a, const Sent& b) { return a.arrival < b.arrival; });
  std::vector<std::uint32_t> received;
  for (const Sent& each : sent) received.push_back(each.number);
  return received;
}

TEST(RecordSequence, AgreesWithAModelThatRemembersEverything) {
  const bool ok = rc::check("lost, late and doubled records as in a map of all numbers", [] {
    const std::uint32_t first = *rc::gen::element(std::uint32_t{1}, std::uint32_t{0xffff'ff80}, std::uint32_t{77777});
    const auto received = through_a_network(first);
    RecordSequence sequence;
    std::map<std::uint32_t, int> seen;  // by distance from the first number
    std::uint64_t doubled = 0, late = 0;
    std::uint32_t newest = 0, oldest = 0;
    for (const std::uint32_t number : received) {
      const std::uint32_t distance = number - first;
      Place expected = Place::newest;
      if (seen[distance]++ > 0) {
        expected = Place::doubled;
        ++doubled;
      } else if (seen.size() > 1 && distance < newest) {
        expected = Place::late;
        ++late;
      }
      if (seen.size() == 1) oldest = distance;
      newest = std::max(newest, distance);
      RC_ASSERT(sequence.add(number) == expected);
    }
    std::uint64_t lost = 0;
    for (std::uint32_t i = oldest; i < newest; ++i) lost += seen.count(i) == 0 ? 1 : 0;
    RC_ASSERT(sequence.received() == received.size());
    RC_ASSERT(sequence.doubled() == doubled);
    RC_ASSERT(sequence.late() == late);
    RC_ASSERT(sequence.lost() == lost);
    RC_ASSERT(sequence.restarts() == 0u);
  });
  EXPECT_TRUE(ok);
}

}  // namespace
}  // namespace mrroc::netft::record_sequence_test
