#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace mrroc::cli {

/// The requests of one connection to a run, each with a number of its own, by which its reply is found. One thread.
class OperatorRequests {
 public:
  /// Sends one line to the run.
  using Send = std::function<void(const std::string& line)>;

  explicit OperatorRequests(Send send) : send_(std::move(send)) {}

  /// Sends a request and returns its number.
  std::int64_t send(nlohmann::ordered_json request) {
    request["id"] = ++last_;
    send_(request.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return last_;
  }

 private:
  Send send_;
  std::int64_t last_ = 0;
};

}  // namespace mrroc::cli
