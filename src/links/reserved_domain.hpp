#pragma once

namespace mrroc::links {

/// A DDS domain number that no other deployment of this machine has, for as long as this object lives: what a runner
/// takes when the deployment file names none. The system gives it back when the process dies.
class ReservedDomain {
 public:
  /// Takes the lowest free number of 1..99. Throws SystemError (resources) when all are taken.
  ReservedDomain();
  ~ReservedDomain();
  ReservedDomain(const ReservedDomain&) = delete;
  ReservedDomain& operator=(const ReservedDomain&) = delete;

  int id() const noexcept { return id_; }

 private:
  int id_ = 0;
  int fd_ = -1;
};

}  // namespace mrroc::links
