#include "cli/ros2/trigger_services.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "links/ros2/ros_names.hpp"

namespace mrroc::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kVerbs[] = {"start", "pause", "resume", "trigger", "stop", "estop", "reset"};
// a flood of requests waits here, within what the run reads from one client without slowing it down
constexpr std::size_t kMostOpen = 8;

}  // namespace

TriggerServices::TriggerServices(ros2::Node& node, const std::string& name_space, OperatorRequests& requests)
    : requests_(requests) {
  for (const char* verb : kVerbs)
    verbs_.push_back({verb, {node, ros2::in_namespace(name_space, verb), "std_srvs/srv/Trigger"}});
}

void TriggerServices::poll() {
  for (Verb& verb : verbs_) {
    while (open_.size() < kMostOpen) {
      const auto request = verb.service.take();
      if (!request) break;
      open_.emplace(requests_.send({{"verb", verb.name}}), Call{&verb, *request});
    }
  }
}

bool TriggerServices::take(const Json& line) {
  if (!line.contains("ok")) return false;
  const auto call = open_.find(line.value("id", std::int64_t{0}));
  if (call == open_.end()) return false;
  Reply reply;
  reply.success = line.value("ok", false);
  reply.message = line.value("text", "");
  if (const std::string expected = line.value("expected", ""); !expected.empty())
    reply.message += ", expected " + expected;
  call->second.verb->service.reply(call->second.request, reply);
  open_.erase(call);
  return true;
}

void TriggerServices::refuse_open() {
  for (const auto& [id, call] : open_) {
    Reply reply;
    reply.message = "the run has ended";
    call.verb->service.reply(call.request, reply);
  }
  open_.clear();
}

}  // namespace mrroc::cli
