// Domains on every kind of network device, as a user without capabilities, in separate network namespaces.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "links/exchange/robot_requester.hpp"
#include "links/peer_process.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "links/transport/domain.hpp"
#include "links/transport/neighbour.hpp"
#include "links/transport/own_network.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

/// One command and its answer, together larger than every MTU here except the jumbo ones.
void exchange(const DomainOptions& options, const std::string& peer_interface, const Neighbour* machine_of_peer) {
  const std::string& of_peer = peer_interface;
  std::vector<PeerProcess> peers;
  const auto start = [&] { peers.emplace_back("remote", options.id, "t/arm", 20, of_peer); };
  if (machine_of_peer != nullptr) {
    machine_of_peer->inside(start);
    test::drop_capabilities();
  } else {
    test::drop_capabilities();
    start();
  }
  Domain domain(options);
  TestClock clock;
  RobotRequester link(domain, clock, "t/arm", "peer", 10000);
  ASSERT_NO_THROW(link.connect(kPatience));
  RobotState state;
  link.send({});
  EXPECT_NO_THROW(link.receive(state));
}

struct Layout {
  std::string name;
  std::vector<std::string> commands;  ///< of iproute2
  std::string interface;              ///< "": loopback, omitted
  std::string host;                   ///< the processes' addresses as peers; "": no hosts
};

void PrintTo(const Layout& layout, std::ostream* out) { *out << layout.name; }

class OnOneMachine : public testing::TestWithParam<Layout> {};

TEST_P(OnOneMachine, TwoProcessesFindEachOther) {
  const Layout& layout = GetParam();
  in_own_network([&] {
    for (const std::string& command : layout.commands) ip(command);
    DomainOptions options{.id = 7, .interface = layout.interface, .lease = 20};
    if (!layout.host.empty()) options.hosts = {layout.host};
    exchange(options, layout.interface + (layout.host.empty() ? "" : "," + layout.host), nullptr);
  });
}

const std::string kCard = "link add card0 type veth peer name card1";
const std::string kUp = "link set card0 up";
const std::string kAddress = "address add 192.0.2.1/24 dev card0";

INSTANTIATE_TEST_SUITE_P(
    Domain, OnOneMachine,
    testing::Values(
        Layout{"Loopback", {"link set lo multicast off"}, "", ""},
        Layout{"LoopbackWithMulticast", {"link set lo multicast on"}, "", ""},
        Layout{"LoopbackWithAllMulticastAndPromiscuous",
               {"link set lo multicast on", "link set lo allmulticast on promisc on"},
               "",
               ""},
        Layout{"LoopbackOfMtu576", {"link set lo mtu 576"}, "", ""},
        Layout{"LoopbackWithMulticastAndHosts", {"link set lo multicast on"}, "lo", "127.0.0.1"},
        Layout{
            "LoopbackBySecondAddress", {"link set lo multicast on", "address add 10.9.9.9/32 dev lo"}, "10.9.9.9", ""},
        Layout{"LoopbackBySecondAddressOf127", {"address add 127.0.0.2/8 dev lo"}, "127.0.0.2", "127.0.0.2"},
        Layout{"LoopbackWithout127", {"address add 10.9.9.9/32 dev lo", "address del 127.0.0.1/8 dev lo"}, "", ""},
        Layout{"CardAsItComes", {kCard, kAddress, kUp}, "card0", "192.0.2.1"},
        Layout{"CardWithoutHosts", {kCard, kAddress, kUp}, "card0", ""},
        Layout{"CardWithoutMulticast", {kCard, kAddress, kUp, "link set card0 multicast off"}, "card0", "192.0.2.1"},
        Layout{"CardBySecondAddress",
               {kCard, kAddress, "address add 198.51.100.1/24 dev card0", kUp},
               "198.51.100.1",
               "198.51.100.1"},
        Layout{"CardOfMtu576", {kCard, kAddress, kUp, "link set card0 mtu 576"}, "card0", ""},
        Layout{"CardOfMtu9000", {kCard, kAddress, kUp, "link set card0 mtu 9000"}, "card0", "192.0.2.1"},
        Layout{"CardWithPeerAddress",
               {kCard, "address add 10.8.0.2 peer 10.8.0.1 dev card0", kUp, "link set card0 multicast off arp off"},
               "card0",
               "10.8.0.2"}),
    [](const auto& test) { return test.param.name; });

struct Cabling {
  std::string name;
  std::vector<std::string> here, there;  ///< commands of iproute2, for card0 and card1
  std::string address_here, address_there;
};

void PrintTo(const Cabling& cabling, std::ostream* out) { *out << cabling.name; }

class OnTwoMachines : public testing::TestWithParam<Cabling> {};

TEST_P(OnTwoMachines, TwoProcessesFindEachOther) {
  const Cabling& cabling = GetParam();
  in_own_network([&] {
    const Neighbour other("card0", "card1");
    for (const std::string& command : cabling.here) ip(command);
    for (const std::string& command : cabling.there) other.ip(command);
    const std::string hosts = "," + cabling.address_here + "," + cabling.address_there;
    exchange({.id = 7,
              .interface = cabling.address_here,
              .hosts = {cabling.address_here, cabling.address_there},
              .lease = 20},
             cabling.address_there + hosts, &other);
  });
}

const std::string kHere = "address add 192.0.2.1/24 dev card0", kThere = "address add 192.0.2.2/24 dev card1";

INSTANTIATE_TEST_SUITE_P(
    Domain, OnTwoMachines,
    testing::Values(
        Cabling{"AsTheyCome", {kHere}, {kThere}, "192.0.2.1", "192.0.2.2"},
        Cabling{"WithoutMulticast",
                {kHere, "link set card0 multicast off"},
                {kThere, "link set card1 multicast off"},
                "192.0.2.1",
                "192.0.2.2"},
        Cabling{"MulticastOnOneSide", {kHere, "link set card0 multicast off"}, {kThere}, "192.0.2.1", "192.0.2.2"},
        Cabling{
            "Mtu576", {kHere, "link set card0 mtu 576"}, {kThere, "link set card1 mtu 576"}, "192.0.2.1", "192.0.2.2"},
        Cabling{"Mtu9000",
                {kHere, "link set card0 mtu 9000"},
                {kThere, "link set card1 mtu 9000"},
                "192.0.2.1",
                "192.0.2.2"},
        Cabling{"SecondAddresses",
                {kHere, "address add 198.51.100.1/24 dev card0"},
                {kThere, "address add 198.51.100.2/24 dev card1"},
                "198.51.100.1",
                "198.51.100.2"},
        Cabling{"PointToPoint",
                {"address add 10.8.0.1 peer 10.8.0.2 dev card0", "link set card0 multicast off"},
                {"address add 10.8.0.2 peer 10.8.0.1 dev card1", "link set card1 multicast off"},
                "10.8.0.1",
                "10.8.0.2"}),
    [](const auto& test) { return test.param.name; });

std::string refusal(const std::string& interface) {
  try {
    find_interface(interface);
  } catch (const SystemError& error) {
    EXPECT_EQ(error.code(), ErrorCode::configuration);
    return error.detail();
  }
  return "none";
}

TEST(Interface, ReportsAnInterfaceThatIsDownOrHasNoAddress) {
  in_own_network([] {
    ip(kCard);
    EXPECT_NE(refusal("card0").find("'card0' is down"), std::string::npos) << refusal("card0");
    ip(kAddress);
    EXPECT_NE(refusal("card0").find("'card0' is down"), std::string::npos) << refusal("card0");
    EXPECT_NE(refusal("192.0.2.1").find("'card0' is down"), std::string::npos) << refusal("192.0.2.1");
    ip("link set card0 up");
    EXPECT_EQ(refusal("card0"), "none") << "an unplugged cable may be plugged in later";
    ip("address flush dev card0");
    EXPECT_NE(refusal("card0").find("'card0' has no IPv4 address"), std::string::npos) << refusal("card0");
    EXPECT_NE(refusal("card9").find("'card9'"), std::string::npos) << refusal("card9");
    EXPECT_NE(refusal("192.0.2.9").find("lo (127.0.0.1)"), std::string::npos) << refusal("192.0.2.9");
    ip("link set lo down");
    EXPECT_NE(refusal("").find("'lo' is down"), std::string::npos) << refusal("");
    EXPECT_NE(refusal("lo").find("'lo' is down"), std::string::npos) << refusal("lo");
    ip("link set lo up");
    ip("address flush dev lo");
    EXPECT_NE(refusal("").find("'lo' has no IPv4 address"), std::string::npos) << refusal("");
  });
}

}  // namespace
}  // namespace mrroc::links
