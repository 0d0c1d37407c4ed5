#include "can/hub.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <latch>
#include <memory>
#include <stdexcept>
#include <thread>

#include "can/hub_address.hpp"
#include "can/hub_bus.hpp"
#include "can_bus/receiving.hpp"
#include "canopen/random_frames.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::can {
namespace {

using test::frames_until;
using test::next_frame;

constexpr std::uint32_t kEnd = 0x7ff;

template <class Action>
std::string refusal(Action&& action) {
  try {
    action();
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

class HubTest : public testing::Test {
 protected:
  task_test::ScratchFolder folder_;
  std::filesystem::path path_ = folder_ / "bus";
};

TEST_F(HubTest, OnlyItsUserMaySendThroughIt) {
  const Hub hub(path_);
  EXPECT_EQ(std::filesystem::status(path_).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

TEST_F(HubTest, AllButTheSenderGetAllInOrder) {
  Hub hub(path_);
  const auto first = open_bus(hub.name()), second = open_bus(hub.name()), third = open_bus(hub.name());
  EXPECT_TRUE(rc::check("frames of two senders", [&] {
    auto frames = *rc::gen::container<std::vector<Frame>>(rc::gen::arbitrary<Frame>());
    for (Frame& frame : frames) {
      frame.id %= kEnd;
      frame.error = false;
    }
    std::vector<Frame> of_first, of_second;
    for (const Frame& frame : frames) {
      const bool by_first = frame.id % 2 == 0;
      RC_ASSERT((by_first ? *first : *second).send(frame) == Sent::yes);
      (by_first ? of_first : of_second).push_back(frame);
    }
    RC_ASSERT(first->send({kEnd, {}}) == Sent::yes);
    RC_ASSERT(second->send({kEnd, {}}) == Sent::yes);
    RC_ASSERT(frames_until(*first, kEnd) == of_second);
    RC_ASSERT(frames_until(*second, kEnd) == of_first);
    std::vector<Frame> heard = frames_until(*third, kEnd);
    const std::vector<Frame> rest = frames_until(*third, kEnd);
    heard.insert(heard.end(), rest.begin(), rest.end());
    for (const auto* const sent : {&of_first, &of_second}) {
      std::vector<Frame> same;
      for (const Frame& frame : heard)
        if ((frame.id % 2 == 0) == (sent == &of_first)) same.push_back(frame);
      RC_ASSERT(same == *sent);
    }
  }));
}

TEST_F(HubTest, CountsFramesAndCanLoseOrCorruptThem) {
  Hub hub(path_, [](Frame& frame) {
    if (frame.id == 2) frame.data[0] = 99;
    return frame.id != 1;
  });
  const auto sender = open_bus(hub.name()), receiver = open_bus(hub.name());
  for (std::uint32_t id = 0; id < 4; ++id) sender->send({id, {7}});
  EXPECT_EQ(next_frame(*receiver), (Frame{0, {7}}));
  EXPECT_EQ(next_frame(*receiver), (Frame{2, {99}}));
  EXPECT_EQ(next_frame(*receiver), (Frame{3, {7}}));
  EXPECT_EQ(hub.frames(), 3u);
}

TEST_F(HubTest, FiltersLetErrorFramesThrough) {
  Hub hub(path_);
  const auto sender = open_bus(hub.name()), receiver = open_bus(hub.name());
  receiver->filter(std::vector<Filter>{{0x183, 0x7ff}, {0x700, 0x780}});
  Frame error;
  error.error = true;
  error.id = 0x40;
  for (const Frame& frame : {Frame{0x182, {}}, Frame{0x183, {1}}, Frame{0x080, {}}, Frame{0x77f, {2}}, error})
    sender->send(frame);
  EXPECT_EQ(next_frame(*receiver), (Frame{0x183, {1}}));
  EXPECT_EQ(next_frame(*receiver), (Frame{0x77f, {2}}));
  EXPECT_EQ(next_frame(*receiver), error);
  receiver->filter({});
  sender->send({0x183, {}});
  sender->send(error);
  EXPECT_EQ(next_frame(*receiver), error) << "no filter: nothing else";
}

TEST_F(HubTest, CarriesFramesOfCanFd) {
  Hub hub(path_);
  const auto sender = open_bus(hub.name()), receiver = open_bus(hub.name());
  EXPECT_TRUE(sender->carries_fd());
  Frame frame;
  frame.id = 0x123;
  frame.fd = frame.bit_rate_switch = true;
  frame.size = 64;
  for (std::size_t i = 0; i < frame.size; ++i) frame.data[i] = static_cast<std::uint8_t>(i);
  sender->send(frame);
  sender->send({0x123, {1, 2}});
  EXPECT_EQ(next_frame(*receiver), frame);
  EXPECT_EQ(next_frame(*receiver), (Frame{0x123, {1, 2}})) << "classical frames stay classical";
}

TEST_F(HubTest, TakesNoMoreThanItsQueueHolds) {
  std::latch held(1);
  Hub hub(path_, [&held](Frame&) {
    held.wait();
    return true;
  });
  HubBus bus(path_.string());
  Sent sent = Sent::yes;
  for (int i = 0; i < 1'000'000 && sent == Sent::yes; ++i) sent = bus.send({1, {}});
  EXPECT_EQ(sent, Sent::full);
  held.count_down();
  while ((sent = bus.send({1, {}})) == Sent::full) std::this_thread::yield();
  EXPECT_EQ(sent, Sent::yes);
}

TEST_F(HubTest, BusIsDownWhenHubEnds) {
  auto hub = std::make_unique<Hub>(path_);
  const auto bus = open_bus(hub->name());
  hub.reset();
  EXPECT_FALSE(std::filesystem::exists(path_));
  EXPECT_EQ(next_frame(*bus), std::nullopt) << "at once";
  EXPECT_EQ(bus->send({1, {}}), Sent::down);
}

TEST_F(HubTest, LeavingClientDoesNotDisturbOthers) {
  Hub hub(path_);
  const auto stays = open_bus(hub.name()), receiver = open_bus(hub.name());
  for (int i = 0; i < 20; ++i) {
    auto leaves = open_bus(hub.name());
    leaves->send({1, {}});
    leaves.reset();
    EXPECT_EQ(next_frame(*stays), (Frame{1, {}})) << "its frames are not lost";
    EXPECT_EQ(next_frame(*receiver), (Frame{1, {}}));
    stays->send({2, {}});
    EXPECT_EQ(next_frame(*receiver), (Frame{2, {}}));
  }
}

/// The leaving client's end of the socket is reset; the kernel reports this before its frames.
TEST_F(HubTest, FramesOfALeavingClientWithUnreadFramesArrive) {
  Hub hub(path_);
  const auto stays = open_bus(hub.name());
  for (std::uint32_t i = 1; i <= 20; ++i) {
    auto leaves = open_bus(hub.name());
    const auto later = open_bus(hub.name());
    stays->send({i, {}});
    ASSERT_EQ(next_frame(*later), (Frame{i, {}})) << "then the leaving client has it, too";
    for (std::uint32_t k = 1; k <= 10; ++k) leaves->send({0x100 + k, {}});
    leaves.reset();
    for (std::uint32_t k = 1; k <= 10; ++k) ASSERT_EQ(next_frame(*stays), (Frame{0x100 + k, {}})) << i;
  }
}

TEST_F(HubTest, ReceivesNothingWithoutFrames) {
  Hub hub(path_);
  const auto bus = open_bus(hub.name());
  Frame frame;
  EXPECT_FALSE(bus->receive(frame, 0));
  EXPECT_FALSE(bus->receive(frame, clock::monotonic_ns() + 1'000'000));
}

TEST_F(HubTest, ReportsInvalidPath) {
  EXPECT_EQ(refusal([&] { open_bus("unix:" + path_.string()); }),
            "CAN hub '" + path_.string() + "': No such file or directory, expected the socket of a running hub");
  const Hub hub(path_);
  EXPECT_EQ(refusal([&] { const Hub second(path_); }),
            "CAN hub '" + path_.string() + "': Address already in use, expected an unused path");
  const std::string too_long(200, 'x');
  EXPECT_EQ(refusal([&] { open_bus("unix:" + too_long); }),
            "CAN hub '" + too_long + "': 200 characters of path, expected 1 to 107");
  EXPECT_EQ(refusal([] { open_bus("unix:"); }), "CAN hub '': 0 characters of path, expected 1 to 107");
}

/// The remains of a killed hub: the file of its socket.
void leave_behind(const std::filesystem::path& path) {
  const sockaddr_un address = hub_address(path.string());
  const int socket = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
  EXPECT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ::close(socket);
}

TEST_F(HubTest, ReplacesAKilledHub) {
  leave_behind(path_);
  Hub hub(path_);
  EXPECT_EQ(std::filesystem::status(path_).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  const auto sender = open_bus(hub.name()), receiver = open_bus(hub.name());
  sender->send({1, {2}});
  EXPECT_EQ(next_frame(*receiver), (Frame{1, {2}}));
}

TEST_F(HubTest, LivingHubKeepsItsPathAndItsClients) {
  Hub hub(path_);
  const auto sender = open_bus(hub.name()), receiver = open_bus(hub.name());
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(refusal([&] { const Hub second(path_); }),
              "CAN hub '" + path_.string() + "': Address already in use, expected an unused path");
  sender->send({1, {2}});
  EXPECT_EQ(next_frame(*receiver), (Frame{1, {2}}));
  EXPECT_NO_THROW(open_bus(hub.name())) << "its file exists";
}

TEST_F(HubTest, OneOfManySimultaneousHubsSurvives) {
  for (int i = 0; i < 50; ++i) {
    leave_behind(path_);
    std::array<std::unique_ptr<Hub>, 8> hubs;
    {
      std::latch all(hubs.size());
      std::vector<std::jthread> starters;
      for (std::unique_ptr<Hub>& hub : hubs)
        starters.emplace_back([&] {
          all.arrive_and_wait();
          refusal([&] { hub = std::make_unique<Hub>(path_); });
        });
    }
    ASSERT_EQ(std::count(hubs.begin(), hubs.end(), nullptr), static_cast<long>(hubs.size()) - 1);
    EXPECT_NO_THROW(open_bus("unix:" + path_.string()));
  }
}

TEST_F(HubTest, RemovesOnlyASocketWithoutListener) {
  const auto refused = [this] { return !refusal([this] { const Hub hub(path_); }).empty(); };
  std::ofstream(path_) << "a file";
  EXPECT_TRUE(refused());
  EXPECT_EQ(std::filesystem::file_size(path_), 6u);
  std::filesystem::remove(path_);
  std::filesystem::create_directory(path_);
  EXPECT_TRUE(refused());
  EXPECT_TRUE(std::filesystem::is_directory(path_));
  std::filesystem::remove(path_);
  leave_behind(folder_ / "other");
  std::filesystem::create_symlink(folder_ / "other", path_);
  EXPECT_TRUE(refused());
  EXPECT_TRUE(std::filesystem::is_symlink(path_));
  EXPECT_TRUE(std::filesystem::is_socket(folder_ / "other"));
}

TEST(OpenBus, ReportsAnUnusableInterface) {
  // the text depends on whether this kernel has CAN; socket_bus_test.cpp checks the full text
  for (const std::string name : {"nosuchcan", "", "a_name_that_is_longer_than_any"})
    EXPECT_TRUE(refusal([&] { open_bus(name); }).starts_with("CAN interface '" + name + "': ")) << name;
}

}  // namespace
}  // namespace mrroc::can
