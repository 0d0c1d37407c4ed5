#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "cli/ros2/operator_requests.hpp"
#include "links/ros2/service.hpp"
#include "messages/std_srvs_cyclone/trigger_reply.hpp"
#include "messages/std_srvs_cyclone/trigger_request.hpp"

namespace mrroc::cli {

/// The operator's verbs without arguments as services of type std_srvs/srv/Trigger, below the node's name. A request is
/// sent to the run as any operator's; its answer becomes the reply. One thread.
class TriggerServices {
 public:
  /// `name_space`: of the services. The node and `requests` outlive it.
  TriggerServices(ros2::Node& node, const std::string& name_space, OperatorRequests& requests);

  /// Sends the requests that have come, of which the run owes a bounded number of answers. Does not wait.
  void poll();
  /// Takes the run's answer to a request; false when the line is no answer of these.
  bool take(const nlohmann::ordered_json& line);
  /// Refuses what is still open: the run has ended.
  void refuse_open();

 private:
  using Request = messages::std_srvs_cyclone::TriggerRequest;
  using Reply = messages::std_srvs_cyclone::TriggerReply;
  struct Verb {
    std::string name;
    ros2::Service<Request, Reply> service;
  };
  struct Call {
    Verb* verb;
    Request request;
  };

  OperatorRequests& requests_;
  std::vector<Verb> verbs_;
  std::map<std::int64_t, Call> open_;
};

}  // namespace mrroc::cli
