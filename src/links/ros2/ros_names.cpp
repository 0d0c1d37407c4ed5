#include "links/ros2/ros_names.hpp"

namespace mrroc::ros2 {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name_character(char c) { return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

}  // namespace

std::string dds_topic(std::string_view topic) { return std::string("rt").append(topic); }
std::string dds_request_topic(std::string_view service) { return std::string("rq").append(service).append("Request"); }
std::string dds_reply_topic(std::string_view service) { return std::string("rr").append(service).append("Reply"); }

std::string action_name(std::string_view action, std::string_view part) {
  return std::string(action).append("/_action/").append(part);
}

std::string dds_type(std::string_view type) {
  const std::size_t name = type.rfind('/') + 1;
  std::string text;
  for (const char c : type.substr(0, name)) {
    if (c == '/')
      text += "::";
    else
      text += c;
  }
  text += "dds_::";
  text += type.substr(name);
  text += '_';
  return text;
}

std::string ros_name(std::string_view text) {
  std::string name;
  for (const char c : text) name += is_name_character(c) ? c : '_';
  if (name.empty() || is_digit(name.front())) name.insert(name.begin(), '_');
  return name;
}

std::string in_namespace(std::string_view space, std::string_view name) {
  std::string text(space);
  if (!text.ends_with('/')) text += '/';
  text += name;
  return text;
}

}  // namespace mrroc::ros2
