// Attacks of an unknown participant without keys on a process whose ports it reaches.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "links/code_of.hpp"
#include "links/cyclone/forged_handshake.hpp"
#include "links/cyclone/forged_packets.hpp"
#include "links/exchange/robot_requester.hpp"
#include "links/peer_process.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "links/transport/dds_log.hpp"
#include "links/transport/domain.hpp"
#include "links/transport/test_keys.hpp"
#include "messages.h"

namespace mrroc::links {
namespace {

namespace fs = std::filesystem;

constexpr Tick kSilence = 2500;  // 5 s: a link without replies for this time is cut
constexpr std::uint32_t kExchanges = 2000;

/// Exchanges messages with a peer, and calls `forge` before each of them with the peer's writer of states and an
/// increasing number. Returns the code of the error that cuts the link, none when the link survives. Without keys the
/// timeout is longer: the link is cut when the receiving thread has had the processor.
ErrorCode fate(const fs::path& keys, const std::function<std::string(const Guid&, std::uint32_t)>& forge) {
  FreeDomain number;
  const auto before = open_descriptors();
  Domain domain({.id = number.id(), .lease = 20, .keys = keys});
  const LoopbackSender unknown(ports_since(before));
  TestClock clock;
  PeerProcess peer("respond", number.id(), "cell/arm", 20, keys);
  RobotRequester link(domain, clock, "cell/arm", "peer", kSilence);
  link.connect(kPatience);
  std::optional<Guid> writer;
  EXPECT_TRUE(
      eventually([&] { return (writer = foreign_writer(domain.participant(), "cell/arm/state")).has_value(); }));
  RobotState first;  // its reply may take longer
  link.send({});
  link.receive(first);
  return code_of(
      [&] {
        for (std::uint32_t i = 0; i < (keys.empty() ? 50 * kExchanges : kExchanges); ++i) {
          if (i % 10 == 0) unknown.send(forge(*writer, i));
          RobotState state;
          link.send({});
          link.receive(state);
        }
      },
      "peer");
}

std::string heartbeat(const Guid& writer, std::uint32_t number) { return forged_heartbeat(writer, 1'000'000 + number); }

std::string farewell(const Guid& writer, std::uint32_t number) {
  Guid participant = writer;
  constexpr Guid kParticipant{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0xc1};
  std::copy(kParticipant.begin() + 12, kParticipant.end(), participant.begin() + 12);
  return forged_farewell(participant, 1'000 + number);
}

TEST(Stranger, ForgedHeartbeatStallsOnlyALinkWithoutKeys) {
  const TestKeys keys("cell");
  EXPECT_EQ(fate({}, heartbeat), ErrorCode::process_silent);
  EXPECT_EQ(fate(keys.folder(), heartbeat), ErrorCode::none);
}

TEST(Stranger, ForgedFarewellCutsOnlyALinkWithoutKeys) {
  const TestKeys keys("cell");
  EXPECT_EQ(fate({}, farewell), ErrorCode::process_died);
  EXPECT_EQ(fate(keys.folder(), farewell), ErrorCode::none);
}

TEST(Stranger, ForgedHandshakeEndsNoProcess) {
  const TestKeys keys("cell");
  FreeDomain number;
  const auto before = open_descriptors();
  Domain domain({.id = number.id(), .lease = 20, .keys = keys.folder()});
  const LoopbackSender unknown(ports_since(before));
  dds_guid_t own{};
  ASSERT_EQ(dds_get_guid(domain.participant(), &own), DDS_RETCODE_OK);
  Guid victim{};
  std::copy_n(own.v, victim.size(), victim.begin());
  for (int i = 0; i < 20; ++i) {
    const Guid participant{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, static_cast<std::uint8_t>(i), 0, 0, 1, 0xc1};
    unknown.send(forged_identity(participant));
    // Cyclone lets a new participant be first for 10 ms
    for (int milliseconds = 0; milliseconds < 10; ++milliseconds) {
      unknown.send(forged_handshake(participant, victim));
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  const auto log = dds_log_messages();
  EXPECT_TRUE(std::any_of(log.begin(), log.end(), [](const std::string& line) {
    return line.find("Validate remote identity failed") != std::string::npos;
  })) << "none of their identities was checked";
  TestClock clock;
  PeerProcess peer("respond", number.id(), "cell/arm", 20, keys.folder());
  RobotRequester link(domain, clock, "cell/arm", "peer", 10000);
  EXPECT_NO_THROW(link.connect(kPatience));
}

/// A participant with keys tolerates the packets of an unknown one without keys, sent as the writer of handshakes, and
/// then communicates.
void bears(const std::function<std::vector<std::string>(const Guid& writer, const Guid& reader)>& packets) {
  const TestKeys keys("cell");
  FreeDomain number;
  const auto before = open_descriptors();
  Domain domain({.id = number.id(), .lease = 20, .keys = keys.folder()});
  const LoopbackSender unknown(ports_since(before));
  for (int i = 0; i < 20; ++i) {
    const Guid participant{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, static_cast<std::uint8_t>(i), 0, 0, 1, 0xc1};
    unknown.send(forged_identity(participant));
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    for (const std::string& packet : packets(entity_of(participant, 0x000201c3), entity_of({}, 0x000201c4)))
      unknown.send(packet);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  TestClock clock;
  PeerProcess peer("respond", number.id(), "cell/arm", 20, keys.folder());
  RobotRequester link(domain, clock, "cell/arm", "peer", 10000);
  EXPECT_NO_THROW(link.connect(kPatience));
}

TEST(Stranger, ForgedFragmentsDoNotCorruptMemory) {
  bears([](const Guid& writer, const Guid& reader) {
    return std::vector{forged_fragment(writer, reader, 0, 1000, 2000),
                       forged_fragment(writer, reader, 1000, 60000, 60000)};
  });
}

TEST(Stranger, HandshakeThatClaimsToBeAKeyEndsNoProcess) {
  bears([](const Guid& writer, const Guid& reader) {
    return std::vector{forged_data(writer, reader, kPlain, std::string(16, '\0'), kKeyPayload),
                       forged_data(writer, reader, kPlain, std::string(16, '\0'), kNoPayload)};
  });
}

TEST(Stranger, FragmentedHandshakeThatClaimsToBeAKeyEndsNoProcess) {
  bears([](const Guid& writer, const Guid& reader) {
    return std::vector{forged_fragment(writer, reader, 0, 1000, 2000, true),
                       forged_fragment(writer, reader, 1000, 2000, 2000, true)};
  });
}

/// The type information of idlc (XTypes 1.3, 7.6.3.2.1) with a minimal or complete number of an unknown kind.
std::string forged_type(std::uint8_t number_kind, std::uint8_t forged_kind) {
  const auto& written = mrroc_wire_ProcessStatus_desc.type_information;
  std::string type(reinterpret_cast<const char*>(written.data), written.sz);
  const auto at = type.find(static_cast<char>(number_kind), 16);
  EXPECT_NE(at, std::string::npos);
  type[at] = static_cast<char>(forged_kind);
  return type;
}

/// A participant, with keys or without, receives descriptions of participants with a type of an unknown kind, and
/// communicates.
void bears_types(const fs::path& keys) {
  FreeDomain number;
  const auto before = open_descriptors();
  Domain domain({.id = number.id(), .lease = 20, .keys = keys});
  const LoopbackSender unknown(ports_since(before));
  constexpr std::uint8_t kMinimal = 0xf1, kComplete = 0xf2;
  for (const std::uint8_t number_kind : {kMinimal, kComplete})
    for (int kind = 0; kind <= 0xff; kind += 3) {
      const auto forged_kind = static_cast<std::uint8_t>(kind);
      const Guid participant{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, number_kind, forged_kind, 0, 0, 1, 0xc1};
      unknown.send(
          forged_announcement(participant, kPlainEndpoints, kTypeInformation, forged_type(number_kind, forged_kind)));
    }
  TestClock clock;
  PeerProcess peer("respond", number.id(), "cell/arm", 20, keys);
  RobotRequester link(domain, clock, "cell/arm", "peer", 10000);
  EXPECT_NO_THROW(link.connect(kPatience));
}

TEST(Stranger, TypeOfUnknownKindEndsNoProcess) {
  const TestKeys keys("cell");
  bears_types({});
  bears_types(keys.folder());
}

TEST(Stranger, CycloneSetsNoTimerForAHandshake) {
  // an unfinished handshake would block its thread after 100 s: too long for a test
  void* const function = ::dlsym(RTLD_DEFAULT, "dds_security_fsm_set_timeout");
  Dl_info found{};
  ASSERT_NE(::dladdr(function, &found), 0);
  EXPECT_EQ(fs::path(found.dli_fname).filename(), "links_test") << "not of this program";
}

}  // namespace
}  // namespace mrroc::links
