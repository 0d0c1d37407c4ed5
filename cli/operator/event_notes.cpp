#include "cli/operator/event_notes.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "config/entries/robot_orders.hpp"
#include "config/entries/trajectory_entry.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::cli {

namespace {

/// The keys of an order, as config::read_robot_order reads them.
std::string text_of(const std::string& command, const config::RobotOrder& order) {
  const std::string amount = config::number_text(order.amount) + "\n";
  std::string text = "robot = \"" + order.robot + "\"\n";
  if (command == "jog" || command == "step")
    text += "axis = \"" + order.axis + "\"\nin = \"" + order.frame + "\"\n" +
            (command == "jog" ? "velocity = " : "distance = ") + amount;
  if (command == "tool") text += "tool = \"" + order.tool + "\"\n";
  if (command == "go") text += "posture = \"" + order.posture + "\"\n";
  if (command == "output") text += "output = \"" + order.axis + "\"\nvalue = " + amount;
  return text;
}

}  // namespace

EventNotes::EventNotes(int fd, std::filesystem::path path, const config::Deployment& deployment)
    : fd_(fd), path_(std::move(path)), deployment_(deployment) {}

void EventNotes::note(const config::Event& event) {
  const std::string text = text_of(event, deployment_);
  for (std::string_view rest = text; !rest.empty();) {
    const ssize_t size = ::write(fd_, rest.data(), rest.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0)
      throw std::runtime_error("cannot write the noted events " + path_.string() + ": " +
                               (size < 0 ? std::strerror(errno) : "nothing was taken"));
    rest.remove_prefix(static_cast<std::size_t>(size));
  }
}

std::string text_of(const config::Event& event, const config::Deployment& deployment) {
  std::string text = "[[events]]\ntick = " + std::to_string(event.tick) + "\ncommand = \"" + event.command + "\"\n";
  if (event.command == "answer") {
    const auto asks = [&event](const config::SensorEntry& sensor) { return sensor.name == event.asker; };
    const bool sensor = std::any_of(deployment.sensors.begin(), deployment.sensors.end(), asks);
    text += (sensor ? "sensor = \"" : "process = \"") + event.asker + "\"\n";
    text += "value = " + config::number_text(event.value) + "\n";
    if (event.question != 0) text += "question = " + std::to_string(event.question) + "\n";
  }
  if (event.command == "follow" || event.command == "cancel") text += "robot = \"" + event.order.robot + "\"\n";
  if (event.trajectory) text += config::text_of(*event.trajectory);
  if (event.command == "speed") text += "value = " + config::number_text(event.value) + "\n";
  if (config::is_robot_order(event.command)) text += text_of(event.command, event.order);
  return text + "\n";
}

}  // namespace mrroc::cli
