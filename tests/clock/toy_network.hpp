#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "clock/clock.hpp"

namespace mrroc::clock {

/// A transport for tests with the difficulties of a real one: messages are in the kernel for a while, and a listener
/// thread in each process stores them whenever it is scheduled. Every node can send to every other one.
class ToyNetwork {
 public:
  static constexpr std::size_t kNodes = 8;

  struct Message {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::uint64_t sequence = 0;
    std::uint64_t delta = 0;
    std::uint32_t hops = 0;
    std::uint32_t padding = 0;
  };

  /// To be made before the processes are forked.
  ToyNetwork();
  ~ToyNetwork();
  ToyNetwork(const ToyNetwork&) = delete;
  ToyNetwork& operator=(const ToyNetwork&) = delete;

  static std::string name(std::size_t node) { return "node" + std::to_string(node); }

 private:
  friend class ToyNode;
  std::array<std::array<int, 2>, kNodes> sockets_{};  // read end, write end
};

/// One process's end of the network.
class ToyNode {
 public:
  /// Registers the node's links and starts its listener. Before `clock.start()`.
  ToyNode(const ToyNetwork& network, std::uint32_t node, Clock& clock);
  ~ToyNode();
  ToyNode(const ToyNode&) = delete;
  ToyNode& operator=(const ToyNode&) = delete;

  void send(std::uint32_t to, std::uint32_t hops);
  /// Takes the visible messages out, ordered by link name, then sequence.
  std::vector<ToyNetwork::Message> receive();

 private:
  void listen();

  const ToyNetwork& network_;
  std::uint32_t node_;
  Clock& clock_;
  std::array<int, ToyNetwork::kNodes> senders_{};
  std::array<int, ToyNetwork::kNodes> receivers_{};
  std::array<std::uint64_t, ToyNetwork::kNodes> sequences_{};
  std::mutex mutex_;
  std::vector<ToyNetwork::Message> mailbox_;
  std::thread listener_;
};

/// Keeps the calling thread busy for an unpredictable time up to `microseconds`, which differs between runs.
void stray(unsigned microseconds);

}  // namespace mrroc::clock
