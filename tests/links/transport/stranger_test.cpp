// What someone without keys can do to a process whose ports he reaches.
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

constexpr Tick kSilence = 2500;  // 5 s: a link whose replies stay away for so long is cut
constexpr std::uint32_t kExchanges = 2000;

/// Exchanges messages with a peer, `forge` being called before each of them with the peer's writer of states and a
/// number that rises; the code of the error that cuts the link, none when it lives on. Without keys a link is given
/// longer: it is cut when the thread that heard the stranger has had the processor.
ErrorCode fate(const fs::path& keys, const std::function<std::string(const Guid&, std::uint32_t)>& forge) {
  FreeDomain number;
  const auto before = open_descriptors();
  Domain domain({.id = number.id(), .lease = 20, .keys = keys});
  const LoopbackSender stranger(ports_since(before));
  TestClock clock;
  PeerProcess peer("respond", number.id(), "cell/arm", 20, keys);
  RobotRequester link(domain, clock, "cell/arm", "peer", kSilence);
  link.connect(kPatience);
  std::optional<Guid> writer;
  EXPECT_TRUE(
      eventually([&] { return (writer = foreign_writer(domain.participant(), "cell/arm/state")).has_value(); }));
  return code_of(
      [&] {
        for (std::uint32_t i = 0; i < (keys.empty() ? 50 * kExchanges : kExchanges); ++i) {
          if (i % 10 == 0) stranger.send(forge(*writer, i));
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

TEST(Stranger, AForgedHeartbeatStallsAPlainLinkButNoneWithKeys) {
  const TestKeys keys("cell");
  EXPECT_EQ(fate({}, heartbeat), ErrorCode::process_silent);
  EXPECT_EQ(fate(keys.folder(), heartbeat), ErrorCode::none);
}

TEST(Stranger, AForgedFarewellCutsAPlainLinkButNoneWithKeys) {
  const TestKeys keys("cell");
  EXPECT_EQ(fate({}, farewell), ErrorCode::process_died);
  EXPECT_EQ(fate(keys.folder(), farewell), ErrorCode::none);
}

TEST(Stranger, AForgedHandshakeEndsNoProcess) {
  const TestKeys keys("cell");
  FreeDomain number;
  const auto before = open_descriptors();
  Domain domain({.id = number.id(), .lease = 20, .keys = keys.folder()});
  const LoopbackSender stranger(ports_since(before));
  dds_guid_t own{};
  ASSERT_EQ(dds_get_guid(domain.participant(), &own), DDS_RETCODE_OK);
  Guid victim{};
  std::copy_n(own.v, victim.size(), victim.begin());
  for (int i = 0; i < 20; ++i) {
    const Guid participant{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, static_cast<std::uint8_t>(i), 0, 0, 1, 0xc1};
    stranger.send(forged_identity(participant));
    // Cyclone gives a new participant 10 ms to be first
    for (int milliseconds = 0; milliseconds < 10; ++milliseconds) {
      stranger.send(forged_handshake(participant, victim));
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  const auto log = dds_log_messages();
  EXPECT_TRUE(std::any_of(log.begin(), log.end(), [](const std::string& line) {
    return line.find("Validate remote identity failed") != std::string::npos;
  })) << "no identity of theirs was looked at";
  TestClock clock;
  PeerProcess peer("respond", number.id(), "cell/arm", 20, keys.folder());
  RobotRequester link(domain, clock, "cell/arm", "peer", 10000);
  EXPECT_NO_THROW(link.connect(kPatience));
}

/// A participant with keys bears what a stranger, who has none, sends it as the writer of hand-shakes, and then talks.
void bears(const std::function<std::vector<std::string>(const Guid& writer, const Guid& reader)>& packets) {
  const TestKeys keys("cell");
  FreeDomain number;
  const auto before = open_descriptors();
  Domain domain({.id = number.id(), .lease = 20, .keys = keys.folder()});
  const LoopbackSender stranger(ports_since(before));
  for (int i = 0; i < 20; ++i) {
    const Guid participant{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, static_cast<std::uint8_t>(i), 0, 0, 1, 0xc1};
    stranger.send(forged_identity(participant));
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    for (const std::string& packet : packets(entity_of(participant, 0x000201c3), entity_of({}, 0x000201c4)))
      stranger.send(packet);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  TestClock clock;
  PeerProcess peer("respond", number.id(), "cell/arm", 20, keys.folder());
  RobotRequester link(domain, clock, "cell/arm", "peer", 10000);
  EXPECT_NO_THROW(link.connect(kPatience));
}

TEST(Stranger, ForgedFragmentsWriteBehindNoMemory) {
  bears([](const Guid& writer, const Guid& reader) {
    return std::vector{forged_fragment(writer, reader, 0, 1000, 2000),
                       forged_fragment(writer, reader, 1000, 60000, 60000)};
  });
}

TEST(Stranger, AHandshakeThatSaysItIsOnlyAKeyEndsNoProcess) {
  bears([](const Guid& writer, const Guid& reader) {
    return std::vector{forged_data(writer, reader, kPlain, std::string(16, '\0'), kKeyPayload),
                       forged_data(writer, reader, kPlain, std::string(16, '\0'), kNoPayload)};
  });
}

TEST(Stranger, AHandshakeOfFragmentsThatSayTheyAreAKeyEndsNoProcess) {
  bears([](const Guid& writer, const Guid& reader) {
    return std::vector{forged_fragment(writer, reader, 0, 1000, 2000, true),
                       forged_fragment(writer, reader, 1000, 2000, 2000, true)};
  });
}

/// What idlc has written of a type (XTypes 1.3, 7.6.3.2.1), its minimal or complete number being of a kind that
/// there is not.
std::string forged_type(std::uint8_t number_kind, std::uint8_t forged_kind) {
  const auto& written = mrroc_wire_ProcessStatus_desc.type_information;
  std::string type(reinterpret_cast<const char*>(written.data), written.sz);
  const auto at = type.find(static_cast<char>(number_kind), 16);
  EXPECT_NE(at, std::string::npos);
  type[at] = static_cast<char>(forged_kind);
  return type;
}

/// A participant, with keys or without, is told of participants whose descriptions name a type of no kind, and talks.
void bears_types(const fs::path& keys) {
  FreeDomain number;
  const auto before = open_descriptors();
  Domain domain({.id = number.id(), .lease = 20, .keys = keys});
  const LoopbackSender stranger(ports_since(before));
  constexpr std::uint8_t kMinimal = 0xf1, kComplete = 0xf2;
  for (const std::uint8_t number_kind : {kMinimal, kComplete})
    for (int kind = 0; kind <= 0xff; kind += 3) {
      const auto forged_kind = static_cast<std::uint8_t>(kind);
      const Guid participant{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, number_kind, forged_kind, 0, 0, 1, 0xc1};
      stranger.send(
          forged_announcement(participant, kPlainEndpoints, kTypeInformation, forged_type(number_kind, forged_kind)));
    }
  TestClock clock;
  PeerProcess peer("respond", number.id(), "cell/arm", 20, keys);
  RobotRequester link(domain, clock, "cell/arm", "peer", 10000);
  EXPECT_NO_THROW(link.connect(kPatience));
}

TEST(Stranger, ATypeOfNoKindEndsNoProcess) {
  const TestKeys keys("cell");
  bears_types({});
  bears_types(keys.folder());
}

TEST(Stranger, CycloneSetsNoTimerForAHandshake) {
  // after 100 s of one that no one finishes it would block the thread of hand-shakes: too long for a test
  void* const function = ::dlsym(RTLD_DEFAULT, "dds_security_fsm_set_timeout");
  Dl_info found{};
  ASSERT_NE(::dladdr(function, &found), 0);
  EXPECT_EQ(fs::path(found.dli_fname).filename(), "links_test") << "not this program's";
}

}  // namespace
}  // namespace mrroc::links
