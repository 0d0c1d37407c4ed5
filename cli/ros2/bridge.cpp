#include "cli/ros2/bridge.hpp"

#include <poll.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "cli/record/standard_messages.hpp"
#include "cli/ros2/event_numbers.hpp"
#include "cli/ros2/sensor_frames.hpp"
#include "links/ros2/ros_names.hpp"

namespace mrroc::cli {

namespace {

constexpr int kTurn = 10;                                   // ms between two looks for requests
constexpr std::int64_t kDiagnosticsPeriod = 1'000'000'000;  // ns
constexpr const char* kWorld = "world";

/// ROS 2 compares stamps with the system's clock.
std::int64_t system_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

ros2::Distro distro_of(const std::string& name) {
  if (name == "humble") return ros2::Distro::humble;
  return name == "iron" || name == "jazzy" ? ros2::Distro::iron : ros2::Distro::kilted;
}

ros2::NodeOptions options_of(const config::Ros2Entry& entry, const std::string& deployment) {
  return {.domain = entry.domain.value_or(0),
          .distro = distro_of(entry.distro),
          .node = "mrroc_" + ros2::ros_name(deployment),
          .node_namespace = entry.name_space,
          .interface = entry.interface};
}

}  // namespace

Bridge::Bridge(const config::Ros2Entry& entry, WatchedRun& run)
    : run_(run.connection),
      requests_([this](const std::string& line) { run_.send_line(line); }),
      name_space_(entry.name_space),
      node_name_(ros2::in_namespace(name_space_, "mrroc_" + ros2::ros_name(run.deployment.name))),
      node_(options_of(entry, run.deployment.name)),
      stamps_(run.simulated, run.deployment.servo_period),
      tf_(node_, "/tf"),
      tf_static_(node_, "/tf_static", ros2::Durability::last),
      diagnostics_(node_, "/diagnostics"),
      rosout_(node_, "/rosout", ros2::Durability::log),
      views_(camera_views(run.deployment, run.camera_files)),
      cameras_(node_, views_, name_space_, kWorld),
      hardware_cameras_(node_, views_, name_space_),
      states_(run.deployment.name) {
  const config::Deployment& deployment = run.deployment;
  if (run.simulated) clock_.emplace(node_, "/clock");
  add_robots(deployment);
  for (const config::SensorEntry& sensor : deployment.sensors)
    if (sensor.gives_wrench)
      wrenches_.try_emplace(sensor.name, node_,
                            ros2::in_namespace(ros2::in_namespace(name_space_, sensor.name), "wrench"));
  if (entry.commands) add_commands(distro_of(entry.distro), deployment);
  node_.announce();
}

/// One robot has the names that a tool expects without any set-up; of several each has a namespace and a prefix.
void Bridge::add_robots(const config::Deployment& deployment) {
  const bool one = deployment.robots.size() == 1;
  messages::tf2_msgs::TFMessage fixed;
  for (const config::RobotEntry& robot : deployment.robots) {
    const auto prefix = [one](const std::string& name) { return one ? "" : name + "/"; };
    const std::string below = robot.mount.empty() ? kWorld : prefix(robot.mount) + record::tool_frame(robot.mount);
    RobotFrames frames(robot, prefix(robot.name), below);
    fixed.transforms.insert(fixed.transforms.end(), frames.fixed().begin(), frames.fixed().end());
    const std::string space = one ? name_space_ : ros2::in_namespace(name_space_, robot.name);
    robots_.try_emplace(robot.name, node_, robot, space, std::move(frames));
  }
  const auto flange = [this](const std::string& robot) { return robots_.at(robot).frames().flange(); };
  for (const config::SensorEntry& sensor : deployment.sensors) {
    if (cameras_.has(sensor.name)) continue;  // its frame comes with its pictures
    if (auto frame = sensor_frame(sensor, flange, kWorld)) fixed.transforms.push_back(std::move(*frame));
  }
  tf_static_.publish(fixed);
}

void Bridge::add_commands(ros2::Distro distro, const config::Deployment& deployment) {
  services_.emplace(node_, node_name_, requests_);
  const auto folder = std::filesystem::absolute(run_.path()).parent_path();
  for (const auto& [name, robot] : robots_) {
    if (robot.frames().joints().empty()) continue;
    actions_.try_emplace(name, node_, distro, name_space_,
                         FollowedRobot{name, robot.frames().joints(), deployment.servo_period}, folder, requests_,
                         [this](const std::string& text) { log(messages::rcl_interfaces::Log::WARN, text); });
  }
}

void Bridge::serve(int stop) {
  run_.send_line(Json{{"verb", "echo"}, {"of", "all"}}.dump());
  if (!actions_.empty()) status_request_ = requests_.send({{"verb", "status"}});
  for (bool connected = true; connected;) {
    pollfd entries[2]{{stop, POLLIN, 0}, {run_.descriptor(), POLLIN, 0}};
    ::poll(entries, 2, kTurn);
    if (entries[0].revents != 0) {
      for (auto& [robot, action] : actions_) {
        action.cancel();
        action.abort_open("the bridge has ended");
      }
      return;
    }
    std::vector<std::string> lines;
    connected = run_.read_lines(lines);
    for (const std::string& line : lines) take(line);
    if (services_) services_->poll();
    for (auto& [robot, action] : actions_) action.poll(stamps_.at(system_ns()));
    beat();
  }
  if (services_) services_->refuse_open();
  for (auto& [robot, action] : actions_) action.abort_open("the run has ended");
}

void Bridge::take(const std::string& line) {
  using messages::rcl_interfaces::Log;
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object() || take_reply(json)) return;
  const std::string event = json.value("event", "");
  if (event == "robot") {
    take_robot(json);
  } else if (event == "reading") {
    take_reading(json);
  } else if (event == "world") {
    cameras_.take(line, stamps_.of(json.value("tick", Tick{0}), system_ns()));
  } else if (event == "yield") {
    if (const auto action = actions_.find(json.value("robot", "")); action != actions_.end())
      action->second.set_yielded(json.value("open", false));
  } else if (event == "process") {
    states_.take(json);
  } else if (event == "message") {
    log(Log::INFO, json.value("text", ""));
  } else if (event == "question") {
    log(Log::WARN, "question of " + json.value("from", "") + ": " + json.value("text", ""));
  } else if (event == "end") {
    const std::string reason = json.value("reason", "");
    if (!reason.empty()) log(Log::ERROR, reason);
  }
}

void Bridge::take_robot(const Json& event) {
  const auto robot = robots_.find(event.value("name", ""));
  if (robot == robots_.end()) return;
  const Tick tick = event.value("tick", Tick{0});
  newest_ = std::max(newest_.value_or(tick), tick);
  const messages::builtin_interfaces::Time stamp = stamps_.of(tick, system_ns());
  robot->second.publish(event, stamp, frames_.transforms);
  if (const auto action = actions_.find(robot->first); action != actions_.end())
    action->second.take_state(event, stamp);
  states_.take(event);
}

bool Bridge::take_reply(const Json& line) {
  if (services_ && services_->take(line)) return true;
  if (!actions_.empty() && line.contains("ok") && line.value("id", std::int64_t{0}) == status_request_) {
    if (const auto data = line.find("data"); data != line.end() && data->is_object())
      for (const Json& robot : data->value("yields", Json::array()))
        if (const auto action = actions_.find(robot.is_string() ? robot.get<std::string>() : "");
            action != actions_.end())
          action->second.set_yielded(true);
    return true;
  }
  for (auto& [robot, action] : actions_)
    if (action.take_reply(line)) return true;
  return false;
}

void Bridge::take_reading(const Json& event) {
  const std::string name = event.value("name", "");
  const auto wrench = wrenches_.find(name);
  const auto values = event.find("values");
  if (wrench == wrenches_.end() || values == event.end() || event.contains("error")) return;
  std::array<double, 6> numbers{};
  std::size_t count = 0;
  for (const Json& value : *values)
    if (count < numbers.size()) numbers[count++] = value.is_number() ? value.get<double>() : 0;
  if (count == numbers.size())
    wrench->second.publish(record::to_wrench(name, stamps_.of(event.value("tick", Tick{0}), system_ns()), numbers));
}

void Bridge::log(std::uint8_t level, const std::string& text) {
  messages::rcl_interfaces::Log message;
  message.stamp = stamps_.at(system_ns());
  message.level = level;
  message.name = node_name_.substr(1);
  message.msg = text;
  rosout_.publish(message);
}

void Bridge::beat() {
  while (const auto problem = cameras_.take_problem()) log(messages::rcl_interfaces::Log::WARN, *problem);
  if (!frames_.transforms.empty()) {
    tf_.publish(frames_);
    frames_.transforms.clear();
  }
  const std::int64_t now = system_ns();
  hardware_cameras_.publish_new(now, [&](Tick tick) { return stamps_.of(tick, now); });
  if (clock_ && newest_ != published_) {
    messages::rosgraph_msgs::Clock message;
    message.clock = stamps_.at(now);
    clock_->publish(message);
    published_ = newest_;
  }
  if (now >= next_diagnostics_) {
    next_diagnostics_ = now + kDiagnosticsPeriod;
    diagnostics_.publish(states_.message(stamps_.at(now)));
  }
}

}  // namespace mrroc::cli
