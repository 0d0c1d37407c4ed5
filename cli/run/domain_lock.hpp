#pragma once

#include <optional>

namespace mrroc::cli {

/// Reserves a DDS domain of this host for one deployment: two deployments on one domain would slow each other's
/// discovery. The lock is an abstract Unix socket: the kernel releases it however the runner ends.
class DomainLock {
 public:
  /// Takes domain `wanted`, or a free one when -1. `avoided`: that of ROS 2, whose nodes are no part of the deployment.
  /// Throws std::runtime_error when none is free, or when the wanted one is to be avoided.
  explicit DomainLock(int wanted, std::optional<int> avoided = std::nullopt);
  ~DomainLock();
  DomainLock(const DomainLock&) = delete;
  DomainLock& operator=(const DomainLock&) = delete;

  int domain() const noexcept { return domain_; }

 private:
  bool take(int domain);

  int socket_ = -1;
  int domain_ = -1;
};

}  // namespace mrroc::cli
