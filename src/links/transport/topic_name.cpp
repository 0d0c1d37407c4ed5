#include "links/transport/topic_name.hpp"

#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

constexpr std::size_t kLongest = 95;  // the capacity of the clock's memory

bool letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool digit(char c) { return c >= '0' && c <= '9'; }

[[noreturn]] void refuse(std::string_view topic, const std::string& reason) {
  throw SystemError(ErrorCode::configuration, "topic name '" + std::string(topic) + "': " + reason);
}

}  // namespace

void check_topic_name(std::string_view topic) {
  if (topic.empty()) refuse(topic, "must not be empty");
  if (topic.size() > kLongest) refuse(topic, "longer than " + std::to_string(kLongest) + " characters");
  if (!letter(topic.front())) refuse(topic, "must begin with a letter or '_'");
  for (const char c : topic) {
    if (!letter(c) && !digit(c) && c != '/') {
      refuse(topic, std::string("has '") + c + "'; expected letters, digits, '_' and '/'");
    }
  }
  if (topic.back() == '/' || topic.find("//") != std::string_view::npos) refuse(topic, "a part between '/' is empty");
}

std::string topic_name(std::string_view prefix, std::string_view name) {
  std::string topic{prefix};
  topic.append("/").append(name);
  check_topic_name(topic);
  return topic;
}

}  // namespace mrroc::links
