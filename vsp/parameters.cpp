#include "vsp/parameters.hpp"

#include "mrroc/errors.hpp"

namespace mrroc::vsp {

namespace {

const std::vector<double>& numbers(const config::SensorEntry& entry, const std::string& key, std::size_t size) {
  const auto found = entry.numbers.find(key);
  const std::size_t count = found == entry.numbers.end() ? 0 : found->second.size();
  if (count != size) refuse(entry, key, std::to_string(count) + " numbers", std::to_string(size));
  return found->second;
}

}  // namespace

double number(const config::SensorEntry& entry, const std::string& key) { return numbers(entry, key, 1)[0]; }

Eigen::Vector3d vector3(const config::SensorEntry& entry, const std::string& key) {
  return Eigen::Vector3d{numbers(entry, key, 3).data()};
}

void refuse(const config::SensorEntry& entry, const std::string& key, const std::string& problem,
            const std::string& expected) {
  throw SystemError(ErrorCode::configuration,
                    "sensors." + entry.name + "." + key + ": " + problem + ", expected " + expected,
                    {"", entry.name, 0, 0});
}

}  // namespace mrroc::vsp
