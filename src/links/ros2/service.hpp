#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "links/ros2/node.hpp"
#include "messages/cdr_reader.hpp"
#include "messages/cdr_writer.hpp"

namespace mrroc::ros2 {

/// The two topics of a service, encoded, as rmw_cyclonedds has them. One thread.
class RawService {
 public:
  /// `name`: absolute, "/press/start". `type`: "std_srvs/srv/Trigger". Throws SystemError (resources). The node
  /// outlives it, and shows it from its next `announce` on.
  RawService(Node& node, const std::string& name, const std::string& type);
  ~RawService();
  RawService(RawService&&) noexcept;

  /// The next request, or nothing. Does not wait.
  std::optional<std::vector<std::byte>> take();
  void reply(std::vector<std::byte> cdr) noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A service whose messages begin with the caller's `client` and `sequence`. One thread.
template <class Request, class Reply>
class Service {
 public:
  /// As of RawService.
  Service(Node& node, const std::string& name, const std::string& type) : raw_(node, name, type) {}

  /// The next request, or nothing; messages that are no request are counted. Does not wait.
  std::optional<Request> take() {
    while (const auto bytes = raw_.take()) {
      try {
        return messages::from_cdr<Request>(*bytes);
      } catch (const messages::CdrError&) {
        ++malformed_;
      }
    }
    return std::nullopt;
  }
  void reply(const Request& to, Reply reply) {
    reply.client = to.client;
    reply.sequence = to.sequence;
    raw_.reply(messages::to_cdr(reply));
  }
  std::uint64_t malformed() const noexcept { return malformed_; }

 private:
  RawService raw_;
  std::uint64_t malformed_ = 0;
};

}  // namespace mrroc::ros2
