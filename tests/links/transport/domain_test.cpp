#include "links/transport/domain.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <random>

#include "links/cyclone/forged_packets.hpp"
#include "links/cyclone/socket_limit.hpp"
#include "links/exchange/robot_requester.hpp"
#include "links/peer_process.hpp"
#include "links/telemetry/status_collector.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "links/transport/dds_log.hpp"
#include "links/transport/descriptors.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

std::string complaint(const DomainOptions& options) {
  try {
    Domain domain(options);
  } catch (const SystemError& error) {
    return error.detail();
  }
  return "none";
}

TEST(Domain, RefusesBadOptions) {
  EXPECT_EQ(complaint({.id = 231}), "DDS domain 231: expected 0..230");
  EXPECT_EQ(complaint({.id = -1}), "DDS domain -1: expected 0..230");
  EXPECT_EQ(complaint({.id = 1, .interface = "lo", .hosts = {"lab<2>"}}),
            "host 'lab<2>': expected a host name or an address");
  EXPECT_EQ(complaint({.id = 1, .hosts = {"lab-pc-2"}}), "hosts are named, but no network interface to reach them by");
  EXPECT_EQ(complaint({.id = 1, .interface = "no_such0"})
                .find("network interface 'no_such0': expected a device or an "
                      "own address, one of lo (127.0.0.1)"),
            0U);
  EXPECT_NE(complaint({.id = 1, .lease = -1}).find("expected 0..60 s"), std::string::npos);
}

TEST(Domain, ReportsRefusalsOfDds) {
  TestDomain net;
  EXPECT_NE(complaint({.id = net.number.id()}).find("creation of DDS domain"), std::string::npos)
      << "only one per process and number";
}

TEST(Domain, IgnoresTheEnvironment) {
  ::setenv("CYCLONEDDS_URI", "<CycloneDDS><NoSuchElement/></CycloneDDS>", 1);
  EXPECT_NO_THROW(TestDomain{});
  ::unsetenv("CYCLONEDDS_URI");
}

TEST(Domain, HasItsOwnBootNumber) {
  std::uint64_t first = 0;
  {
    TestDomain net;
    first = net.domain.boot();
  }
  TestDomain net;
  EXPECT_NE(net.domain.boot(), first);
  EXPECT_TRUE(same_machine(net.domain.boot(), first));
  EXPECT_FALSE(same_machine(net.domain.boot(), first ^ (1ULL << 32U)));
}

TEST(Domain, ConfigurationIsUnicastWithoutSharedMemory) {
  const NetworkInterface loopback = find_interface("");
  const std::string local = dds_configuration({.id = 1}, loopback);
  for (const char* part :
       {"<NetworkInterface address=\"127.0.0.1\" multicast=\"false\"/>", "<Peers><Peer Address=\"127.0.0.1\"/></Peers>",
        "<AllowMulticast>false<", "<ParticipantIndex>auto<", "<Enable>false<", "<MaxAutoParticipantIndex>60<",
        "<LeaseDuration>1000ms<"}) {
    EXPECT_NE(local.find(part), std::string::npos) << part << " in " << local;
  }
  const NetworkInterface network{.device = "eth7", .address = "10.0.0.2", .index = 7};
  const std::string remote =
      dds_configuration({.id = 1, .interface = "eth7", .hosts = {"lab-pc-2", "10.0.0.2", "10.0.0.3"}}, network);
  EXPECT_NE(remote.find("<NetworkInterface address=\"10.0.0.2\" multicast=\"false\"/>"), std::string::npos) << remote;
  EXPECT_NE(remote.find("<Peers><Peer Address=\"10.0.0.2\"/><Peer Address=\"lab-pc-2\"/>"
                        "<Peer Address=\"10.0.0.3\"/></Peers>"),
            std::string::npos)
      << remote;
  EXPECT_NE(dds_configuration({.id = 1, .lease = 0}, loopback).find("<LeaseDuration>3600000ms<"), std::string::npos);
}

TEST(Domain, InterfaceIsFoundByItsDeviceAndByItsAddress) {
  for (const char* name : {"", "lo", "127.0.0.1"}) {
    const NetworkInterface interface = find_interface(name);
    EXPECT_EQ(interface.device, "lo") << name;
    EXPECT_EQ(interface.address, "127.0.0.1") << name;
    EXPECT_EQ(interface.index, ::if_nametoindex("lo")) << name;
    EXPECT_TRUE(interface.loopback) << name;
  }
}

TEST(Domain, DescriptorsCloseOnExecAndSocketsAreRestricted) {
  const auto before = open_descriptors();
  TestDomain net;
  int sockets = 0;
  for (const int fd : open_descriptors()) {
    if (before.contains(fd)) continue;
    EXPECT_NE(::fcntl(fd, F_GETFD) & FD_CLOEXEC, 0) << fd;
    if (!is_udp_socket(fd)) continue;
    ++sockets;
    EXPECT_TRUE(is_limited(fd)) << fd;
  }
  EXPECT_GE(sockets, 2) << "it receives on two ports";
}

/// A socket of this machine with one datagram in transit to it.
struct ListeningSocket {
  ListeningSocket() : fd(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (::bind(fd, reinterpret_cast<const sockaddr*>(&address), size) != 0 ||
        ::getsockname(fd, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
      throw std::runtime_error("no socket");
    }
  }
  ~ListeningSocket() { ::close(fd); }
  ListeningSocket(const ListeningSocket&) = delete;
  ListeningSocket& operator=(const ListeningSocket&) = delete;

  /// Whether a datagram from this machine itself, which arrives through the loopback device, is received.
  bool hears_loopback() const {
    EXPECT_EQ(::sendto(fd, "x", 1, 0, reinterpret_cast<const sockaddr*>(&address), sizeof address), 1);
    char byte = 0;
    return ::recv(fd, &byte, 1, MSG_DONTWAIT) == 1;  // over loopback a datagram arrives before sendto returns
  }

  int fd;
  sockaddr_in address{};
};

TEST(Domain, SocketReceivesFromItsDevicesOnly) {
  const unsigned loopback = ::if_nametoindex("lo");
  const ListeningSocket open, first, second, closed;
  EXPECT_FALSE(is_limited(open.fd));
  EXPECT_TRUE(accept_from(first.fd, loopback, loopback + 1000));
  EXPECT_TRUE(accept_from(second.fd, loopback + 1000, loopback));
  EXPECT_TRUE(accept_from(closed.fd, loopback + 1000, loopback + 1001));
  EXPECT_TRUE(is_limited(closed.fd));
  EXPECT_FALSE(accept_from(-1, loopback, loopback));
  EXPECT_TRUE(open.hears_loopback());
  EXPECT_TRUE(first.hears_loopback());
  EXPECT_TRUE(second.hears_loopback());
  EXPECT_FALSE(closed.hears_loopback());
}

TEST(Domain, MalformedDatagramsAreCountedAndNotPrinted) {
  const auto before = open_descriptors();
  TestDomain net;
  TestClock clock;
  PeerProcess peer("respond", net.domain.id(), "t/arm");
  RobotRequester link(net.domain, clock, "t/arm", "peer", 10000);
  link.connect(kPatience);
  const std::uint64_t messages = dds_log_count();
  ::testing::internal::CaptureStderr();

  const LoopbackSender sender(ports_since(before));
  std::mt19937 random(20240607);
  for (int n = 0; n < 1000; ++n) {
    // an RTPS 2.1 header, a data submessage, and then anything
    std::string datagram("RTPS\x02\x01\x01\x10", 8);
    for (int i = 0; i < 12; ++i) datagram.push_back(static_cast<char>(random()));
    datagram.append("\x15\x05", 2);
    const std::size_t size = 20 + random() % 100;
    for (std::size_t i = 0; i < size; ++i) datagram.push_back(static_cast<char>(random()));
    sender.send(datagram);
  }

  EXPECT_TRUE(eventually([&] { return dds_log_count() > messages; }));
  RobotState state;
  link.send({});
  EXPECT_NO_THROW(link.receive(state)) << "the link must continue";
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  const auto kept = dds_log_messages();
  ASSERT_FALSE(kept.empty());
  EXPECT_LE(kept.size(), 32U);
  EXPECT_NE(kept.back(), "");
}

TEST(Domain, FortyOneProcessesOnOneMachineFindEachOther) {
  TestDomain net;
  StatusCollector collector(net.domain, "t");
  std::vector<PeerProcess> peers;
  for (int i = 0; i < 40; ++i) peers.push_back(PeerProcess("status", net.domain.id(), "t"));
  const auto all_there = [&] {
    collector.poll();
    return collector.processes().size() == peers.size();
  };
  EXPECT_TRUE(eventually(all_there)) << collector.processes().size() << " of 40";
  for (const auto& [name, process] : collector.processes()) {
    EXPECT_EQ(name, "process" + std::to_string(process.status.pid));
    EXPECT_TRUE(process.alive);
  }
}

TEST(Domain, ProcessesOfThisMachineFindEachOtherAlsoWithHosts) {
  // TEST-NET-1: a host that never answers
  FreeDomain number;
  Domain domain({.id = number.id(), .interface = "lo", .hosts = {"192.0.2.250"}, .lease = 20});
  TestClock clock;
  PeerProcess peer("remote", number.id(), "t/arm", 20, "127.0.0.1,127.0.0.1");
  RobotRequester link(domain, clock, "t/arm", "peer", 10000);
  ASSERT_NO_THROW(link.connect(kPatience));
  RobotState state;
  link.send({});
  EXPECT_NO_THROW(link.receive(state));
}

}  // namespace
}  // namespace mrroc::links
