#include "clock/toy_network.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <random>
#include <tuple>

#include "clock/wall/monotonic.hpp"

namespace mrroc::clock {

ToyNetwork::ToyNetwork() {
  for (auto& pair : sockets_)
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET, 0, pair.data()) != 0) std::abort();
}

ToyNetwork::~ToyNetwork() {
  for (const auto& pair : sockets_)
    for (const int end : pair) ::close(end);
}

ToyNode::ToyNode(const ToyNetwork& network, std::uint32_t node, Clock& clock)
    : network_(network), node_(node), clock_(clock) {
  for (std::uint32_t other = 0; other < ToyNetwork::kNodes; ++other) {
    if (other == node) continue;
    senders_[other] = clock.register_sender(ToyNetwork::name(node) + "/" + ToyNetwork::name(other));
    receivers_[other] = clock.register_receiver(ToyNetwork::name(other) + "/" + ToyNetwork::name(node));
  }
  listener_ = std::thread([this] { listen(); });
}

ToyNode::~ToyNode() {
  const ToyNetwork::Message last{node_, node_, 0, 0, 0, 0};  // from itself: the end
  (void)!::send(network_.sockets_[node_][1], &last, sizeof last, MSG_NOSIGNAL);
  listener_.join();
}

void ToyNode::send(std::uint32_t to, std::uint32_t hops) {
  const ToyNetwork::Message message{node_, to, ++sequences_[to], clock_.delta(), hops, 0};
  clock_.sent(senders_[to]);
  if (::send(network_.sockets_[to][1], &message, sizeof message, MSG_NOSIGNAL) < 0) std::abort();
}

std::vector<ToyNetwork::Message> ToyNode::receive() {
  std::vector<ToyNetwork::Message> visible;
  {
    const std::scoped_lock lock(mutex_);
    const auto seen = [this](const ToyNetwork::Message& message) { return clock_.visible(message.delta); };
    std::copy_if(mailbox_.begin(), mailbox_.end(), std::back_inserter(visible), seen);
    std::erase_if(mailbox_, seen);
  }
  std::sort(visible.begin(), visible.end(),
            [](const auto& a, const auto& b) { return std::tie(a.from, a.sequence) < std::tie(b.from, b.sequence); });
  return visible;
}

void ToyNode::listen() {
  ToyNetwork::Message message;
  while (::recv(network_.sockets_[node_][0], &message, sizeof message, 0) == sizeof message && message.from != node_) {
    stray(10);
    {
      const std::scoped_lock lock(mutex_);
      mailbox_.push_back(message);
    }
    clock_.arrived(receivers_[message.from]);
  }
}

void stray(unsigned microseconds) {
  thread_local std::minstd_rand random{std::random_device{}()};
  const std::int64_t end = monotonic_ns() + static_cast<std::int64_t>(random() % (microseconds * 1000));
  while (monotonic_ns() < end) {
  }
}

}  // namespace mrroc::clock
