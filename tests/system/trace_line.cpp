#include "system/trace_line.hpp"

#include <fstream>
#include <sstream>

namespace mrroc::test {

std::vector<double> numbers_after(const std::string& line, const std::string& field) {
  std::vector<double> values;
  const auto at = line.find(field);
  if (at == std::string::npos) return values;
  const auto begin = at + field.size();
  std::istringstream text(line.substr(begin, line.find(' ', begin) - begin));
  for (std::string value; std::getline(text, value, ',');) values.push_back(std::stod(value));
  return values;
}

std::vector<std::string> lines_with(const std::filesystem::path& trace, const std::string& text) {
  std::vector<std::string> found;
  std::ifstream file(trace);
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("tick=") && line.find(text) != std::string::npos) found.push_back(line);
  return found;
}

}  // namespace mrroc::test
