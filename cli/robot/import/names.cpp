#include "cli/robot/import/names.hpp"

#include <algorithm>

namespace mrroc::cli {

namespace {

bool is_letter_or_digit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

}  // namespace

std::string plain_name(std::string_view text) {
  std::string name(text);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !is_letter_or_digit(c) && c != '_' && c != '-' && c != '.'; }, '_');
  return name.empty() ? "part" : name;
}

std::string type_name(std::string_view robot) {
  std::string name(robot);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !is_letter_or_digit(c); }, '_');
  if (name.empty() || name.front() == '_') name = "arm" + name;
  if (name.front() >= '0' && name.front() <= '9') name = "arm_" + name;
  return name;
}

std::vector<std::string> unique_names(const std::vector<std::string>& names, std::size_t longest) {
  std::vector<std::string> result;
  std::set<std::string> used;
  for (const std::string& name : names) {
    const std::string plain = plain_name(name);
    std::string candidate = plain.substr(0, longest);
    for (int number = 2; !used.insert(candidate).second; ++number) {
      std::string ending = "_";
      ending += std::to_string(number);
      candidate = plain.substr(0, longest - ending.size()) + ending;
    }
    result.push_back(candidate);
  }
  return result;
}

}  // namespace mrroc::cli
