#pragma once

#include <fcntl.h>
#include <sched.h>
#include <unistd.h>

#include <cstdlib>

namespace mrroc::links {

/// A network namespace of this thread and of whatever it starts, while it lives: the loopback device, and one more with
/// the address kAddress. Needs root.
class OwnNetwork {
 public:
  static constexpr const char* kAddress = "192.0.2.1";  // TEST-NET-1

  OwnNetwork() : home_(::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC)) {
    laid_ = home_ >= 0 && ::unshare(CLONE_NEWNET) == 0;
    if (!laid_) return;
    complete_ = std::system(
                    "PATH=$PATH:/usr/sbin:/sbin; ip link set lo up && ip link add own0 type veth peer name own1 && "
                    "ip address add 192.0.2.1/24 dev own0 && ip link set own1 up && ip link set own0 up") == 0;
  }
  ~OwnNetwork() {
    if (laid_) ::setns(home_, CLONE_NEWNET);
    if (home_ >= 0) ::close(home_);
  }
  OwnNetwork(const OwnNetwork&) = delete;
  OwnNetwork& operator=(const OwnNetwork&) = delete;

  /// False: the kernel has refused the namespace.
  bool laid() const noexcept { return laid_; }
  /// It has its devices.
  bool complete() const noexcept { return complete_; }

 private:
  int home_;
  bool laid_ = false, complete_ = false;
};

}  // namespace mrroc::links
