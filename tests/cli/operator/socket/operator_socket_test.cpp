#include "cli/operator/socket/operator_socket.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/operator/operator_rig.hpp"
#include "cli/operator/socket/run_connection.hpp"
#include "cli/operator/socket/socket_folder.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::operator_socket_test {
namespace {

using Json = nlohmann::json;

/// A run's socket in a runtime folder of its own, and clients in the same thread.
class OperatorSocketTest : public testing::Test {
 protected:
  OperatorSocketTest() {
    chmod(runtime.path().c_str(), 0700);
    setenv("MRROC_RUNTIME_DIR", (runtime.path() / "mrroc").c_str(), 1);
    rig.next_tick();
    socket.emplace(rig.service, "t");
    rig.service.publish_to([this](const std::string& json, const std::string&) { socket->publish(json); });
  }
  ~OperatorSocketTest() override {
    for (const int fd : fds) close(fd);
    unsetenv("MRROC_RUNTIME_DIR");
  }

  int join() {
    const int fd = connect_to(socket->path());
    EXPECT_GE(fd, 0);
    fcntl(fd, F_SETFL, O_NONBLOCK);
    fds.push_back(fd);
    turn();
    return fd;
  }
  void turn() {
    socket->poll();
    rig.next_tick();
  }
  static void send_text(int fd, const std::string& text) {
    ASSERT_EQ(send(fd, text.data(), text.size(), MSG_NOSIGNAL), std::ssize(text));
  }
  /// The lines that have arrived.
  static std::vector<Json> lines(int fd) {
    std::string text(1 << 20, ' ');
    const ssize_t size = recv(fd, text.data(), text.size(), 0);
    text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    std::vector<Json> found;
    for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
      found.push_back(Json::parse(text.substr(begin, end - begin)));
    return found;
  }
  static bool closed(int fd) {
    char byte = 0;
    ssize_t size = 0;
    while ((size = recv(fd, &byte, 1, 0)) > 0) {
    }
    return size == 0 || errno == ECONNRESET;  // with something that was not read
  }

  task_test::ScratchFolder runtime;
  OperatorRig rig;
  std::optional<OperatorSocket> socket;
  std::vector<int> fds;
};

TEST_F(OperatorSocketTest, OnlyThisUserMayReachIt) {
  struct stat status {};
  ASSERT_EQ(stat(socket->path().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600U);
  ASSERT_EQ(stat(socket->path().parent_path().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0700U);
  socket.reset();
  chmod((runtime.path() / "mrroc").c_str(), 0755);
  EXPECT_THROW(OperatorSocket(rig.service, "t"), std::runtime_error);
}

TEST_F(OperatorSocketTest, RequestGetsItsReplyAfterTheTick) {
  const int client = join();
  EXPECT_EQ(lines(client).at(0).at("mrroc"), OperatorSocket::kProtocol);
  send_text(client, "{\"verb\":\"pause\",\"id\":7}\n");
  socket->poll();
  EXPECT_TRUE(lines(client).empty());
  rig.next_tick();
  const auto replies = lines(client);
  ASSERT_EQ(replies.size(), 1U);
  EXPECT_EQ(replies[0].at("id"), 7);
  EXPECT_EQ(replies[0].at("ok"), true);
  EXPECT_EQ(replies[0].at("tick"), rig.tick);
}

TEST_F(OperatorSocketTest, BadLinesAreRefusedAndTheConnectionStays) {
  const int client = join();
  lines(client);
  for (const char* line : {"\n", "pause\n", "{\"verb\":\"puase\"}\n", "\xff\x01\n", "{\"verb\":[]}\n"}) {
    send_text(client, line);
    turn();
    const auto replies = lines(client);
    ASSERT_EQ(replies.size(), 1U) << line;
    EXPECT_EQ(replies[0].at("ok"), false);
  }
  send_text(client, "{\"verb\":\"status\"}\n");
  turn();
  EXPECT_EQ(lines(client).at(0).at("data").at("task"), "running");
}

TEST_F(OperatorSocketTest, LineThatNeverEndsDisconnectsItsSenderOnly) {
  const int other = join(), client = join();
  lines(other);
  send_text(client, std::string(2 * OperatorSocket::kMaxLine, 'x'));
  for (int i = 0; i < 20; ++i) turn();
  EXPECT_TRUE(closed(client));
  send_text(other, "{\"verb\":\"status\"}\n");
  turn();
  EXPECT_EQ(lines(other).size(), 1U);
}

TEST_F(OperatorSocketTest, ClientThatClosesItsSendingSideGetsItsReplies) {
  const int client = join();
  lines(client);
  send_text(client, "{\"verb\":\"pause\"}\n");
  shutdown(client, SHUT_WR);
  turn();
  EXPECT_EQ(lines(client).at(0).at("ok"), true);
  turn();
  EXPECT_TRUE(closed(client));
}

TEST_F(OperatorSocketTest, CommandIsFreeWhenItsHolderIsGone) {
  const int holder = join(), other = join();
  lines(holder);
  lines(other);
  send_text(holder, "{\"verb\":\"command\"}\n");
  turn();
  send_text(other, "{\"verb\":\"pause\"}\n");
  turn();
  EXPECT_EQ(lines(other).at(0).at("reason"), "not_commander");
  close(holder);
  fds.front() = -1;
  turn();
  send_text(other, "{\"verb\":\"pause\"}\n");
  turn();
  EXPECT_EQ(lines(other).at(0).at("ok"), true);
}

TEST_F(OperatorSocketTest, FloodIsReadSlowlyAndOthersAreServed) {
  const int flood = join(), other = join();
  lines(other);
  const std::string line = "{\"verb\":\"status\"}\n";
  std::size_t sent = 0;
  while (send(flood, line.data(), line.size(), MSG_NOSIGNAL) == std::ssize(line)) ++sent;
  ASSERT_GT(sent, 100U);
  send_text(other, line);
  socket->poll();
  EXPECT_EQ(lines(other).size(), 1U);
  EXPECT_LE(lines(flood).size(), OperatorSocket::kLinesPerTurn + 1);
  pollfd wake{socket->descriptor(), POLLIN, 0};
  EXPECT_EQ(poll(&wake, 1, 0), 0) << "a flood must not wake the run at once";
}

TEST_F(OperatorSocketTest, WatcherThatNeverReadsIsDisconnectedAndMemoryIsBounded) {
  const int watcher = join(), reader = join();
  for (const int fd : {watcher, reader}) send_text(fd, "{\"verb\":\"echo\"}\n");
  turn();
  EXPECT_TRUE(socket->watched());
  std::size_t read = 0;
  for (int i = 0; i < 20000; ++i) {
    rig.service.message("a message of a process, longer than a word");
    read += lines(reader).size();
  }
  turn();
  EXPECT_GE(read, 20000U);
  close(reader);
  fds.back() = -1;
  turn();
  EXPECT_FALSE(socket->watched());
}

TEST_F(OperatorSocketTest, NoMoreThanItsClientsAreServed) {
  for (std::size_t i = 0; i < OperatorSocket::kMaxClients; ++i) join();
  EXPECT_TRUE(closed(join()));
  EXPECT_FALSE(closed(fds.front()));
}

TEST_F(OperatorSocketTest, SocketOfAKilledRunIsRemoved) {
  const auto stale = runtime.path() / "mrroc" / "gone-1.sock";
  close(listen_at(stale));
  ASSERT_TRUE(std::filesystem::exists(stale));
  const auto sockets = operator_sockets();
  EXPECT_EQ(sockets, std::vector{socket->path()});
  EXPECT_FALSE(std::filesystem::exists(stale));
  socket.reset();
  EXPECT_TRUE(operator_sockets().empty());
}

TEST_F(OperatorSocketTest, PathMayBeLongerThanASocketAddress) {
  const auto folder = runtime.path() / std::string(100, 'x') / std::string(100, 'y');
  std::filesystem::create_directories(folder);
  const int fd = listen_at(folder / "t-1.sock");
  const int client = connect_to(folder / "t-1.sock");
  EXPECT_GE(client, 0);
  close(client);
  close(fd);
}

/// In a user namespace many users have one number, and all share /tmp.
TEST_F(OperatorSocketTest, FolderIsThatOfTheUserOutsideANamespace) {
  const std::string user = std::to_string(geteuid());
  const pid_t child = fork();
  if (child == 0) {
    unsetenv("MRROC_RUNTIME_DIR");
    unsetenv("XDG_RUNTIME_DIR");
    if (unshare(CLONE_NEWUSER) != 0) _exit(1);
    std::ofstream("/proc/self/uid_map") << "1234 " << user << " 1";
    if (geteuid() != 1234) _exit(2);
    try {
      _exit(make_socket_folder() == "/tmp/mrroc-" + user ? 0 : 3);
    } catch (const std::exception&) {
      _exit(4);
    }
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST_F(OperatorSocketTest, RunIsFoundByItsName) {
  EXPECT_THROW(RunConnection::to("other"), std::runtime_error);
  const pid_t client = fork();
  if (client == 0) {
    RunConnection run = RunConnection::to("");
    _exit(run.deployment() == "t" && run.request("pause").ok() && RunConnection::to("t").request("status").ok() ? 0
                                                                                                                : 1);
  }
  int status = -1;
  for (int i = 0; i < 30000 && waitpid(client, &status, WNOHANG) == 0; ++i, usleep(1000)) turn();
  EXPECT_EQ(status, 0);
  OperatorSocket second(rig.service, "u");
  EXPECT_THROW(RunConnection::to(""), std::runtime_error) << "more than one";
}

}  // namespace
}  // namespace mrroc::cli::operator_socket_test
