#include "links/transport/security.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "links/code_of.hpp"
#include "links/cyclone/forged_handshake.hpp"
#include "links/cyclone/forged_packets.hpp"
#include "links/exchange/robot_requester.hpp"
#include "links/exchange/robot_responder.hpp"
#include "links/peer_process.hpp"
#include "links/telemetry/status_collector.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "links/transport/dds_log.hpp"
#include "links/transport/domain.hpp"
#include "links/transport/test_keys.hpp"
#include "messages.h"

namespace mrroc::links {
namespace {

namespace fs = std::filesystem;

TEST(Security, ProcessesOfOneDeploymentCommunicate) {
  const TestKeys keys("cell");
  FreeDomain number;
  Domain domain({.id = number.id(), .lease = 20, .keys = keys.folder()});
  EXPECT_TRUE(domain.secured());
  TestClock clock;
  PeerProcess peer("respond", number.id(), "cell/arm", 20, keys.folder());
  RobotRequester link(domain, clock, "cell/arm", "peer", 10000);
  ASSERT_NO_THROW(link.connect(kPatience));
  RobotCommand command;
  command.start_tick = 17;
  link.send(command);
  RobotState state;
  link.receive(state);
  EXPECT_EQ(state.tick, 17U);
}

TEST(Security, SeventeenProcessesWithKeysFindEachOther) {
  const TestKeys keys("cell");
  FreeDomain number;
  Domain domain({.id = number.id(), .lease = 20, .keys = keys.folder()});
  StatusCollector collector(domain, "cell");
  std::vector<PeerProcess> peers;
  for (int i = 0; i < 16; ++i) peers.push_back(PeerProcess("status", number.id(), "cell", 20, keys.folder()));
  EXPECT_TRUE(eventually([&] {
    collector.poll();
    return collector.processes().size() == peers.size();
  })) << collector.processes().size()
      << " of 16";
}

TEST(Security, ProcessWithOtherOrNoKeysCommandsNothing) {
  const TestKeys ours("cell"), theirs("cell");  // of the same name, with all the same rights
  FreeDomain number;
  Domain domain({.id = number.id(), .lease = 20, .keys = ours.folder()});
  TestClock clock;
  RobotResponder link(domain, clock, "cell/arm", 1000);
  int from_us = 0;
  int from_others = 0;
  const auto check = [&] {
    RobotCommand command;
    std::uint64_t sequence = 0;
    if (link.take(command, sequence)) ++(command.start_tick == 1 ? from_us : from_others);
  };
  {
    const PeerProcess without("foreigner", number.id(), "cell/arm", 20, "");
    const PeerProcess other("foreigner", number.id(), "cell/arm", 20, theirs.folder());
    const PeerProcess commander("commander", number.id(), "cell/arm", 20, ours.folder());
    // they all have had enough time when a hundred of the deployment's messages have arrived
    EXPECT_TRUE(eventually([&] {
      check();
      return from_us >= 100;
    })) << from_us;
    EXPECT_EQ(from_others, 0);
  }
  // the same unknown participant is accepted with the keys: only the keys had excluded it
  const PeerProcess admitted("foreigner", number.id(), "cell/arm", 20, ours.folder());
  EXPECT_TRUE(eventually([&] {
    check();
    return from_others > 0;
  }));
}

TEST(Security, KeysAreValidOnlyForTheTopicsOfTheirDeployment) {
  const TestKeys keys("cell"), of_any("");
  FreeDomain number;
  TestClock clock;
  {
    Domain domain({.id = number.id(), .lease = 20, .keys = keys.folder()});
    EXPECT_NO_THROW(RobotRequester(domain, clock, "cell/arm", "peer"));
    EXPECT_EQ(code_of([&] { RobotRequester(domain, clock, "press/arm", "peer"); }, "press/arm"), ErrorCode::resources);
    EXPECT_EQ(code_of([&] { RobotRequester(domain, clock, "cellar/arm", "peer"); }, "cellar/arm"),
              ErrorCode::resources);
  }
  Domain domain({.id = number.id(), .lease = 20, .keys = of_any.folder()});
  EXPECT_NO_THROW(RobotRequester(domain, clock, "press/arm", "peer"));
}

TEST(Security, RefusesMissingKeysAndKeysThatOthersMayRead) {
  const TestKeys keys("cell");
  const auto refused = [&](const std::string& what) {
    return code_of([&] { Domain({.id = 1, .keys = keys.folder()}); }, what) == ErrorCode::configuration;
  };
  const fs::path secret = keys.folder() / KeyFiles::identity_key;
  EXPECT_NO_THROW(check_keys(keys.folder()));
  for (const auto& [path, mode] : {std::pair{secret, "600"}, {keys.folder(), "700"}}) {
    for (const fs::perms others : {fs::perms::group_read, fs::perms::others_read, fs::perms::group_write}) {
      fs::permissions(path, others, fs::perm_options::add);
      EXPECT_TRUE(refused("keys " + path.string() + ": open to other users, expected `chmod " + mode + " " +
                          path.string() + "`"));
      fs::permissions(path, others, fs::perm_options::remove);
    }
  }
  EXPECT_NO_THROW(check_keys(keys.folder()));
  fs::remove(secret);
  EXPECT_TRUE(refused("keys " + secret.string() + ": there is no such file, expected a folder made by `mrroc keys "));
  fs::remove_all(keys.folder());
  EXPECT_TRUE(refused("keys " + keys.folder().string() + ": there is no such folder"));
}

TEST(Security, RefusesKeysThatDoNotBelongTogether) {
  for (const char* file :
       {KeyFiles::authority, KeyFiles::identity, KeyFiles::identity_key, KeyFiles::governance, KeyFiles::permissions}) {
    const TestKeys keys("cell"), others("cell");
    FreeDomain number;
    // only its peers detect a foreign private key: they do not communicate with it
    if (file != KeyFiles::identity_key) {
      fs::copy_file(others.folder() / file, keys.folder() / file, fs::copy_options::overwrite_existing);
      EXPECT_EQ(code_of([&] { Domain({.id = number.id(), .keys = keys.folder()}); }, "participant"),
                ErrorCode::resources)
          << file;
    }
    std::ofstream(keys.folder() / file) << "not a key";
    EXPECT_EQ(code_of([&] { Domain({.id = number.id(), .keys = keys.folder()}); }, "participant"), ErrorCode::resources)
        << file;
  }
}

}  // namespace
}  // namespace mrroc::links
