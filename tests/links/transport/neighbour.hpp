#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string>

#include "links/transport/own_network.hpp"

namespace mrroc::links {

/// Another machine: a network namespace of a separate process, connected to the caller's by a veth pair. The
/// constructor needs root in the caller's namespaces (in_own_network); `send` needs no privileges.
class Neighbour {
 public:
  /// `device` is this side of the pair, `there` the other.
  Neighbour(const std::string& device, const std::string& there) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) throw std::runtime_error("socketpair");
    holder_ = ::fork();
    if (holder_ == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      hold(ends[1]);
      ::_exit(0);
    }
    ::close(ends[1]);
    orders_ = ends[0];
    char ready = 0;
    if (::recv(orders_, &ready, 1, 0) != 1) throw std::runtime_error("no namespace for a neighbour");
    links::ip("link add " + device + " type veth peer name " + there + " netns " + std::to_string(holder_));
    links::ip("link set " + device + " up");
    ip("link set " + there + " up");
  }
  ~Neighbour() {
    ::close(orders_);
    ::kill(holder_, SIGKILL);
    ::waitpid(holder_, nullptr, 0);
  }
  Neighbour(const Neighbour&) = delete;
  Neighbour& operator=(const Neighbour&) = delete;

  /// Runs iproute2 in that namespace.
  void ip(const std::string& arguments) const {
    inside([&] { links::ip(arguments); });
  }
  /// Runs `action` in that namespace, in this thread.
  template <class Action>
  void inside(Action action) const {
    const int home = ::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC);
    const int there = ::open(("/proc/" + std::to_string(holder_) + "/ns/net").c_str(), O_RDONLY | O_CLOEXEC);
    if (::setns(there, CLONE_NEWNET) != 0) throw std::runtime_error("setns");
    action();
    if (::setns(home, CLONE_NEWNET) != 0) throw std::runtime_error("setns");
    ::close(home);
    ::close(there);
  }
  /// Sends a datagram from there; false when the kernel there refuses it.
  bool send(const std::string& datagram, const std::string& address, in_port_t port) const {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = port;
    ::inet_pton(AF_INET, address.c_str(), &to.sin_addr);
    const std::string order = std::string(reinterpret_cast<const char*>(&to), sizeof to) + datagram;
    char sent = 0;
    return ::send(orders_, order.data(), order.size(), 0) >= 0 && ::recv(orders_, &sent, 1, 0) == 1 && sent == 1;
  }

 private:
  static void hold(int orders) {
    char answer = 1;
    if (::unshare(CLONE_NEWNET) != 0 || ::send(orders, &answer, 1, 0) != 1) return;
    std::array<char, 4096> order;
    const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_BROADCAST, &yes, sizeof yes);
    for (ssize_t size = 0; (size = ::recv(orders, order.data(), order.size(), 0)) > 0;) {
      sockaddr_in to{};
      std::memcpy(&to, order.data(), sizeof to);
      const auto length = static_cast<std::size_t>(size) - sizeof to;
      answer =
          ::sendto(socket, order.data() + sizeof to, length, 0, reinterpret_cast<const sockaddr*>(&to), sizeof to) >= 0;
      if (::send(orders, &answer, 1, 0) != 1) return;
    }
  }

  pid_t holder_ = -1;
  int orders_ = -1;
};

}  // namespace mrroc::links
