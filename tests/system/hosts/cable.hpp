#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace mrroc::test {

/// Disturbances of the frames on a cable, in both directions; times in s, the others are probabilities of each frame.
struct CableFaults {
  double delay = 0;
  double jitter = 0;  ///< added to the delay, uniform from 0
  double loss = 0;
  double duplicate = 0;
  double reorder = 0;  ///< held back for 3 ms more, so that others overtake the frame
  double corrupt = 0;  ///< one bit behind the Ethernet header is flipped
  bool cut = false;
};

/// A separate network namespace with only `lo`, removed with the object, even when the test is killed.
class Namespace {
 public:
  /// Throws std::system_error when the kernel refuses.
  Namespace();
  ~Namespace();
  Namespace(const Namespace&) = delete;
  Namespace& operator=(const Namespace&) = delete;

  /// A process that is in the namespace during the lifetime of the object.
  pid_t holder() const noexcept { return holder_; }
  /// The prefix of a command that runs in the namespace.
  std::vector<std::string> command() const;
  /// Runs `ip` in the namespace; throws std::runtime_error when that fails.
  void ip(const std::string& arguments) const;

 private:
  pid_t holder_ = -1;
};

/// During its lifetime the calling thread is in the namespace, with every process that it starts.
class Inside {
 public:
  explicit Inside(const Namespace& space);
  ~Inside();
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

 private:
  int outside_;
};

/// Two hosts, a and b, connected by a cable with disturbances: namespaces with the device `cable0` and the addresses
/// 10.77.0.1 and 10.77.0.2. Each end is one of a veth pair whose other end is in a third namespace, where a thread of
/// this test forwards the frames (this kernel has no netem: docs/decisions/0016-cable.md). The hosts compute their
/// checksums themselves, as for real cables.
class Cable {
 public:
  /// Needs root, at least of a user namespace (privileges.hpp). Throws std::system_error when the kernel refuses
  /// namespaces.
  explicit Cable(std::uint64_t seed = 1);
  ~Cable();
  Cable(const Cable&) = delete;
  Cable& operator=(const Cable&) = delete;

  const Namespace& a() const noexcept { return a_; }
  const Namespace& b() const noexcept { return b_; }
  static constexpr const char* kDevice = "cable0";
  static constexpr const char* kAddressOfA = "10.77.0.1";
  static constexpr const char* kAddressOfB = "10.77.0.2";

  void set(const CableFaults& faults);
  /// Of all devices of the path; 1500 bytes at first.
  void set_mtu(int bytes) const;
  struct Counts {
    std::uint64_t carried = 0, lost = 0, duplicated = 0, reordered = 0, corrupted = 0;
  };
  Counts counts() const;

 private:
  struct Frame;
  void carry();
  void receive(int end, std::vector<Frame>& queue);

  Namespace a_, middle_, b_;
  int ends_[2] = {-1, -1};
  mutable std::mutex mutex_;
  CableFaults faults_;
  Counts counts_;
  std::mt19937_64 random_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace mrroc::test
