#pragma once

namespace mrroc::cli {

/// Keeps a DDS domain of this host for one deployment: two at once on one domain would only slow each other's
/// discovery. The lock is an abstract Unix socket: the kernel gives it back however the runner ends.
class DomainLock {
 public:
  /// Takes domain `wanted`, or a free one when -1. Throws std::runtime_error when there is none.
  explicit DomainLock(int wanted);
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
