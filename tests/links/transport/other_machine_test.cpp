// Datagrams from another machine to the sockets of a domain, whose process has no capabilities. The kernel counts the
// datagrams that a filter drops in the socket's `drops` (proc_net(5), udp).
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "links/cyclone/forged_packets.hpp"
#include "links/test_domain.hpp"
#include "links/transport/dds_log.hpp"
#include "links/transport/descriptors.hpp"
#include "links/transport/domain.hpp"
#include "links/transport/neighbour.hpp"
#include "links/transport/own_network.hpp"

namespace mrroc::links {
namespace {

/// Number of dropped packets of the sockets of this network namespace, by port.
std::map<in_port_t, long> drops() {
  std::map<in_port_t, long> counts;
  std::ifstream file("/proc/thread-self/net/udp");
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::vector<std::string> fields;
    for (std::string word; words >> word;) fields.push_back(word);
    const auto port = static_cast<in_port_t>(std::stoi(fields.at(1).substr(fields.at(1).find(':') + 1), nullptr, 16));
    counts[htons(port)] += std::stol(fields.back());
  }
  return counts;
}

struct Attack {
  std::string name;
  std::vector<std::string> here, there;  ///< commands of iproute2
  std::vector<std::string> targets;
  std::string interface;  ///< of the domain; "": loopback
};

void PrintTo(const Attack& attack, std::ostream* out) { *out << attack.name; }

class OtherMachine : public testing::TestWithParam<Attack> {};

/// An RTPS message that Cyclone logs as malformed.
std::string malformed() {
  std::string datagram("RTPS\x02\x01\x01\x10", 8);
  datagram.append(12, '\x07');
  return datagram + std::string("\x15\x05\x10\x00", 4) + std::string(16, '\xff');
}

TEST_P(OtherMachine, ReachesNoSocket) {
  const Attack& attack = GetParam();
  in_own_network([&] {
    const Neighbour other("card0", "card1");
    ip("address add 192.0.2.1/24 dev card0");
    for (const std::string& command : attack.here) ip(command);
    other.ip("address add 192.0.2.2/24 dev card1");
    for (const std::string& command : attack.there) {
      if (command.starts_with("/"))
        other.inside([&] { std::ofstream(command) << 1; });
      else
        other.ip(command);
    }
    std::ofstream("/proc/sys/net/ipv4/conf/all/route_localnet") << 1;
    test::drop_capabilities();
    const auto before = open_descriptors();
    Domain domain({.id = 7, .interface = attack.interface, .lease = 20});
    const auto ports = ports_since(before);
    ASSERT_GE(ports.size(), 2U);
    const std::uint64_t messages = dds_log_count();
    for (const std::string& target : attack.targets) {
      for (const in_port_t port : ports) {
        const auto dropped = drops()[port];
        ASSERT_TRUE(other.send(malformed(), target, port)) << target;
        // the socket that sends is bound to the domain's own address
        if (port == ports[0] || port == ports[1]) {
          EXPECT_TRUE(eventually([&] { return drops()[port] > dropped; })) << target;
        }
      }
    }
    EXPECT_EQ(dds_log_count(), messages);
    const LoopbackSender sender(ports);
    sender.send(malformed());
    EXPECT_TRUE(eventually([&] { return dds_log_count() > messages; })) << "a permitted datagram is received";
  });
}

INSTANTIATE_TEST_SUITE_P(
    Domain, OtherMachine,
    testing::Values(
        Attack{"ToTheCardsAddress", {}, {}, {"192.0.2.1"}, ""},
        Attack{"ToASecondAddress",
               {"address add 198.51.100.1/24 dev card0"},
               {"address add 198.51.100.2/24 dev card1"},
               {"198.51.100.1", "192.0.2.1"},
               ""},
        Attack{"ToAnAddressOfLoopback",
               {"address add 10.9.9.9/32 dev lo"},
               {"route add 10.9.9.9/32 via 192.0.2.1"},
               {"10.9.9.9"},
               ""},
        Attack{"To127001",
               {},
               {"/proc/sys/net/ipv4/conf/all/route_localnet", "route add 127.0.0.1/32 via 192.0.2.1"},
               {"127.0.0.1"},
               ""},
        Attack{"ToTheBroadcastAddress", {}, {"route add default dev card1"}, {"192.0.2.255", "255.255.255.255"}, ""},
        Attack{"WithMulticastOnLoopback", {"link set lo multicast on"}, {}, {"192.0.2.1"}, ""},
        Attack{"ToACardThatIsNotTheOneNamed",
               {"link add lab0 type veth peer name lab1", "address add 203.0.113.1/24 dev lab0", "link set lab0 up"},
               {"route add 203.0.113.1/32 via 192.0.2.1"},
               {"203.0.113.1", "192.0.2.1"},
               "lab0"}),
    [](const auto& test) { return test.param.name; });

/// Sends malformed messages to the first ports of domain `id` at `address` in an endless loop.
[[noreturn]] void flood(int id, const std::string& address) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  ::inet_pton(AF_INET, address.c_str(), &to.sin_addr);
  const std::string datagram = malformed();
  for (int n = 0;; ++n) {
    to.sin_port = htons(static_cast<in_port_t>(7400 + 250 * id + 10 + n % 2));
    ::sendto(socket, datagram.data(), datagram.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
  }
}

TEST(OtherMachine, ReachesNoSocketWhileTheDomainIsCreated) {
  in_own_network([] {
    const Neighbour other("card0", "card1");
    ip("address add 192.0.2.1/24 dev card0");
    other.ip("address add 192.0.2.2/24 dev card1");
    pid_t child = 0;
    other.inside([&] {
      child = ::fork();
      if (child == 0) flood(7, "192.0.2.1");
    });
    test::drop_capabilities();
    const std::uint64_t messages = dds_log_count();
    for (int i = 0; i < 20; ++i) {
      const auto before = open_descriptors();
      const Domain domain({.id = 7, .lease = 20});
      const in_port_t port = ports_since(before).front();
      EXPECT_TRUE(eventually([&] { return drops()[port] > 0; })) << "the flood has not arrived";
    }
    EXPECT_EQ(dds_log_count(), messages);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  });
}

}  // namespace
}  // namespace mrroc::links
