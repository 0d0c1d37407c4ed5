#include "links/transport/message_ring.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <atomic>
#include <thread>

namespace mrroc::links {
namespace {

/// A message whose words are all equal unless two of them were mixed.
struct Message {
  std::array<std::uint64_t, 40> words{};
};

class Ring {
 public:
  explicit Ring(std::size_t depth) : ring_(depth) {}

  void push(std::size_t buffer = 0) {
    ring_.incoming(buffer).words.fill(pushed_++);
    ring_.push(buffer);
  }
  MessageRing<Message>& operator*() { return ring_; }
  MessageRing<Message>* operator->() { return &ring_; }
  std::uint64_t pushed() const { return pushed_; }

 private:
  MessageRing<Message> ring_;
  std::uint64_t pushed_ = 0;
};

TEST(MessageRing, IsEmptyAtFirst) {
  Ring ring(4);
  EXPECT_EQ(ring->front(), nullptr);
  EXPECT_EQ(ring->overwritten(), 0U);
}

TEST(MessageRing, KeepsTheFrontUntilItIsPopped) {
  Ring ring(2);
  ring.push();
  const Message* const first = ring->front();
  for (int i = 0; i < 10; ++i) ring.push();
  EXPECT_EQ(ring->front(), first) << "the consumer has claimed it";
  EXPECT_EQ(first->words[0], 0U);
  EXPECT_EQ(&ring->pop(), first);
  EXPECT_EQ(ring->front()->words[0], 9U);
  EXPECT_EQ(first->words[0], 0U) << "a popped message is the consumer's until the next one is popped";
  EXPECT_EQ(ring->overwritten(), 8U);
}

/// Any order of pushes and looks: messages come in order, none twice, the newest `depth` of them always; those that are
/// missing are counted.
RC_GTEST_PROP(MessageRing, GivesTheNewestMessagesInOrderAndCountsTheOthers, ()) {
  const auto depth = *rc::gen::inRange<std::size_t>(1, 9);
  Ring ring(depth);
  std::uint64_t next = 0, lost = 0;
  for (const int action : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 5))) {
    if (action < 3) {
      ring.push(static_cast<std::size_t>(action % 2));
      continue;
    }
    const Message* const front = ring->front();
    RC_ASSERT((front != nullptr) == (next + lost < ring.pushed()));
    if (front == nullptr) continue;
    const std::uint64_t number = front->words[0];
    RC_ASSERT(number >= next + lost);
    lost += number - next - lost;
    RC_ASSERT(ring->overwritten() == lost);
    if (action == 3) {
      RC_ASSERT(ring->pop().words[39] == number);
    } else {
      ring->drop();
    }
    ++next;
  }
}

TEST(MessageRing, ThreadsSeeNoMixedMessageAndNoneTwice) {
  constexpr std::uint64_t kMessages = 200'000;
  Ring ring(3);
  std::atomic<bool> done{false};
  std::thread producer([&] {
    for (std::uint64_t i = 0; i < kMessages; ++i) ring.push(i % 2);
    done.store(true);
  });
  std::uint64_t next = 0, seen = 0;
  for (bool last = false; !last;) {
    last = done.load();
    while (ring->front() != nullptr) {
      const Message& message = ring->pop();
      ASSERT_GE(message.words[0], next);
      for (const std::uint64_t word : message.words) ASSERT_EQ(word, message.words[0]);
      next = message.words[0] + 1;
      ++seen;
    }
  }
  producer.join();
  EXPECT_EQ(next, kMessages) << "the newest message is always there";
  EXPECT_EQ(seen + ring->overwritten(), kMessages);
}

}  // namespace
}  // namespace mrroc::links
