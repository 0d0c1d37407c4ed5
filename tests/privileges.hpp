#pragma once

#include <linux/capability.h>
#ifdef __SANITIZE_THREAD__
#include <sanitizer/common_interface_defs.h>
#endif
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

namespace mrroc::test {

/// Makes this process, while it has one thread, root of a user namespace that contains only its own user, so that it
/// may create other namespaces. Does nothing for root. Throws std::runtime_error when the kernel allows no user
/// namespaces.
inline void become_root() {
  const uid_t user = ::geteuid();
  const gid_t group = ::getegid();
  if (user == 0) return;
#ifdef __SANITIZE_THREAD__
  __sanitizer_sandbox_arguments none{};
  __sanitizer_sandbox_on_notify(&none);  // ends the thread that the sanitizer itself may have started
#endif
  if (::unshare(CLONE_NEWUSER) != 0) throw std::runtime_error(std::string{"user namespace: "} + std::strerror(errno));
  std::ofstream("/proc/self/setgroups") << "deny";
  std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
  std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
}

/// Calls `become_root`, and moves this thread and its children into a new network namespace, in which only the loopback
/// device exists and is up. An ordinary user's process cannot return to its previous namespaces.
inline void enter_own_network() {
  become_root();
  if (::unshare(CLONE_NEWNET) != 0) throw std::runtime_error(std::string{"namespace: "} + std::strerror(errno));
  if (std::system("PATH=$PATH:/usr/sbin:/sbin; ip link set lo up") != 0) throw std::runtime_error("ip link set lo up");
}

/// Drops every capability of this process and of its later executions.
inline void drop_capabilities() {
  for (int capability = 0; ::prctl(PR_CAPBSET_READ, capability, 0, 0, 0) >= 0; ++capability) {
    ::prctl(PR_CAPBSET_DROP, capability, 0, 0, 0);
  }
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct none[2]{};
  if (::syscall(SYS_capset, &header, none) != 0) throw std::runtime_error("capset");
}

}  // namespace mrroc::test
