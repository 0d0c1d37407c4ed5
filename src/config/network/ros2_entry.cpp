#include "config/network/ros2_entry.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <stdexcept>

#include "config/network/network_entry.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

constexpr int kLastDomain = 230;  // the ports of domain 231 end beyond 65535
constexpr std::array<std::string_view, 6> kDistros{"humble", "iron", "jazzy", "kilted", "lyrical", "rolling"};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// One part of a namespace.
bool is_name(std::string_view text) {
  return !text.empty() && is_letter(text.front()) &&
         std::all_of(text.begin(), text.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

/// "/", or names, each behind a "/".
bool is_namespace(std::string_view text) {
  if (text == "/") return true;
  if (!text.starts_with('/')) return false;
  while (!text.empty()) {
    text.remove_prefix(1);
    const std::size_t end = std::min(text.find('/'), text.size());
    if (!is_name(text.substr(0, end))) return false;
    text.remove_prefix(end);
  }
  return true;
}

std::string read_distro(const Table& table) {
  std::string distro = table.text("distro");
  if (std::find(kDistros.begin(), kDistros.end(), distro) == kDistros.end())
    table.fail("distro", in_quotes(distro), "humble, iron, jazzy, kilted, lyrical or rolling");
  return distro;
}

std::string read_namespace(const Table& table) {
  std::string name = table.text("namespace");
  if (!is_namespace(name))
    table.fail("namespace", in_quotes(name),
               "\"/\", or names of letters, digits and _, each behind a /: \"/lab/cell\"");
  return name;
}

}  // namespace

std::optional<Ros2Entry> read_ros2(const Table& root) {
  const auto table = root.optional_table("ros2");
  if (!table) return std::nullopt;
  table->only({"domain", "distro", "namespace", "interface", "commands"});
  Ros2Entry entry;
  if (table->has("domain")) entry.domain = static_cast<int>(table->integer("domain", 0, kLastDomain));
  if (table->has("distro")) entry.distro = read_distro(*table);
  if (table->has("namespace")) entry.name_space = read_namespace(*table);
  if (table->has("interface")) entry.interface = read_interface(*table);
  entry.commands = table->boolean_or("commands", entry.commands);
  return entry;
}

int ros2_domain(const Ros2Entry& entry) {
  if (entry.domain) return *entry.domain;
  const char* const text = std::getenv("ROS_DOMAIN_ID");
  if (text == nullptr || *text == '\0') return 0;
  const std::string_view digits = text;
  int domain = -1;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), domain);
  if (error != std::errc{} || end != digits.data() + digits.size() || domain < 0 || domain > kLastDomain)
    throw std::runtime_error("environment: ROS_DOMAIN_ID: " + in_quotes(std::string(digits)) +
                             ", expected a number from 0 to " + std::to_string(kLastDomain));
  return domain;
}

}  // namespace mrroc::config
