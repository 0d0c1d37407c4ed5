#include "drivers/netft/http_get.hpp"

#include <gtest/gtest.h>
#include <poll.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <thread>

#include "clock/wall/monotonic.hpp"
#include "clock/wall/wait.hpp"
#include "drivers/netft/socket.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::netft::http_get_test {
namespace {

/// A server on loopback that gives every client the same bytes and, unless it is `stubborn`, closes the connection.
class Server {
 public:
  explicit Server(std::string answer, bool stubborn = false)
      : answer_(std::move(answer)),
        stubborn_(stubborn),
        listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)),
        thread_([this] { serve(); }) {}
  ~Server() { end(); }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  std::uint16_t port() {
    while (port_ == 0) std::this_thread::yield();
    return port_;
  }
  /// The last request; no other client is served.
  std::string request() {
    end();
    return request_;
  }

 private:
  void end() {
    ended_ = true;
    if (thread_.joinable()) thread_.join();
  }
  void serve() {
    sockaddr_in address = resolve("127.0.0.1", 0);
    socklen_t size = sizeof address;
    ASSERT_EQ(::bind(listener_.get(), generic(address), size), 0);
    ASSERT_EQ(::listen(listener_.get(), 4), 0);
    ASSERT_EQ(::getsockname(listener_.get(), generic(address), &size), 0);
    port_ = ntohs(address.sin_port);
    while (!ended_) {
      if (!clock::wait_for(listener_.get(), POLLIN, clock::monotonic_ns() + clock::kSecond / 100)) continue;
      client_ = Descriptor(::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC));
      char text[1024];
      const ssize_t received = ::recv(client_.get(), text, sizeof text, 0);
      request_.assign(text, static_cast<std::size_t>(std::max<ssize_t>(received, 0)));
      ::send(client_.get(), answer_.data(), answer_.size(), MSG_NOSIGNAL);
      if (!stubborn_) client_ = Descriptor();
    }
  }

  std::string answer_;
  bool stubborn_;
  std::atomic<bool> ended_{false};
  std::atomic<std::uint16_t> port_{0};
  std::string request_;
  Descriptor listener_, client_;
  std::thread thread_;
};

std::string http_refusal(const std::string& answer) {
  try {
    body_of(answer, "http://sensor:80/x");
    return "";
  } catch (const HardwareError& error) {
    EXPECT_EQ(error.code(), ErrorCode::sensor_hardware);
    return error.detail();
  }
}

TEST(HttpGet, ReturnsTheBody) {
  Server server("HTTP/1.0 200 OK\r\nContent-Type: text/xml\r\n\r\n<a/>\n");
  EXPECT_EQ(http_get("127.0.0.1", server.port(), "/netftapi2.xml", 30), "<a/>\n");
  EXPECT_TRUE(server.request().starts_with("GET /netftapi2.xml HTTP/1.0\r\nHost: 127.0.0.1\r\n"));
}

TEST(HttpGet, ServerThatKeepsTheConnectionOpenIsReported) {
  Server server("HTTP/1.1 200 OK\r\nContent-Length: 100\r\n\r\n<a/>", true);
  try {
    http_get("127.0.0.1", server.port(), "/", 0.05);
    FAIL();
  } catch (const HardwareError& error) {
    EXPECT_NE(error.detail().find("no complete answer within 0.05 s, expected the configuration page"),
              std::string::npos)
        << error.what();
  }
}

TEST(HttpGet, EndlessAnswerIsRefused) {
  Server server("HTTP/1.0 200 OK\r\n\r\n" + std::string(kMaxAnswer, 'x'));
  EXPECT_THROW(http_get("127.0.0.1", server.port(), "/", 30), HardwareError);
}

TEST(HttpGet, ClosedPortIsReported) {
  const Descriptor unused(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in address = resolve("127.0.0.1", 0);
  socklen_t size = sizeof address;
  ASSERT_EQ(::bind(unused.get(), generic(address), size), 0);  // but it does not listen
  ASSERT_EQ(::getsockname(unused.get(), generic(address), &size), 0);
  EXPECT_THROW(http_get("127.0.0.1", ntohs(address.sin_port), "/", 30), HardwareError);
}

TEST(HttpGet, RefusesAnswersOfAnotherForm) {
  EXPECT_EQ(http_refusal("HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nab"), "");
  EXPECT_NE(http_refusal("").find("not an answer of HTTP"), std::string::npos);
  EXPECT_NE(http_refusal("SSH-2.0-x\r\n\r\n").find("not an answer of HTTP: 'SSH-2.0-x"), std::string::npos);
  EXPECT_NE(http_refusal("HTTP/1.1 404 Not Found\r\n\r\n").find("status '404 Not Found', expected 200"),
            std::string::npos);
  EXPECT_NE(http_refusal("HTTP/1.1\r\n\r\n").find("status ''"), std::string::npos);
  EXPECT_NE(http_refusal("HTTP/1.1 200 OK\r\ncontent-LENGTH:  3\r\n\r\nab").find("2 bytes, expected a page of '3'"),
            std::string::npos);
  EXPECT_NE(http_refusal("HTTP/1.1 200 OK\r\nContent-Length: -1\r\n\r\nab").find("expected a page of '-1'"),
            std::string::npos);
  EXPECT_NE(http_refusal("HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n").find("without an encoding"),
            std::string::npos);
}

}  // namespace
}  // namespace mrroc::netft::http_get_test
