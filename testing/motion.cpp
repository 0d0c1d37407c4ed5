#include "mrroc/testing/motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace mrroc::task_test {

namespace {

constexpr double kPositionTolerance = 0.01;  // rad or m

std::vector<double> numbers(std::istringstream& words) {
  std::vector<double> values;
  for (std::string word; words >> word;) values.push_back(std::strtod(word.c_str(), nullptr));  // accepts nan, too
  return values;
}

JointVector part(const std::vector<double>& values, std::size_t first, std::size_t count) {
  return Eigen::Map<const Eigen::VectorXd>(values.data() + first, static_cast<Eigen::Index>(count));
}

void read_limits(std::istringstream& words, std::map<std::string, Motion>& motions) {
  std::string robot;
  words >> robot;
  const std::vector<double> values = numbers(words);
  const std::size_t count = values.size() / 3;
  Motion& motion = motions[robot];
  motion.position_min = part(values, 0, count);
  motion.position_max = part(values, count, count);
  motion.velocity_max = part(values, 2 * count, count);
}

/// False: the line is invalid.
bool read_tick(std::istringstream& words, std::map<std::string, Motion>& motions) {
  Tick tick = 0;
  std::string robot;
  int brakes = 0;
  words >> tick >> robot >> brakes;
  const auto found = motions.find(robot);
  if (!words || found == motions.end()) return false;
  const auto count = static_cast<std::size_t>(found->second.velocity_max.size());
  const std::vector<double> values = numbers(words);
  if (values.empty()) return true;  // its drives do not exist yet
  if (values.size() != 2 * count) return false;
  found->second.ticks.push_back(tick);
  found->second.positions.push_back(part(values, 0, count));
  found->second.velocities.push_back(part(values, count, count));
  return true;
}

}  // namespace

Tick Motion::standstill(double speed) const {
  std::size_t first = ticks.size();
  while (first > 0 && velocities[first - 1].cwiseAbs().maxCoeff() <= speed) --first;
  return first == ticks.size() ? kNever : ticks[first];
}

Tick Motion::at_rest(Tick from, double speed) const {
  constexpr std::size_t kLong = 10;  // ticks: a joint that reverses its direction is not at rest
  std::size_t slow = 0;
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    if (ticks[k] < from) continue;
    slow = velocities[k].cwiseAbs().maxCoeff() <= speed ? slow + 1 : 0;
    if (slow == kLong || (slow > 0 && k + 1 == ticks.size())) return ticks[k + 1 - slow];
  }
  return kNever;
}

double Motion::fastest() const {
  double fastest = 0;
  for (const JointVector& velocity : velocities)
    fastest = std::max(fastest, velocity.cwiseAbs().cwiseQuotient(velocity_max).maxCoeff());
  return fastest;
}

std::vector<std::string> Motion::limits_exceeded(double tolerance) const {
  std::vector<std::string> places;
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    for (Eigen::Index j = 0; j < velocity_max.size(); ++j) {
      const double q = positions[k][j], v = velocities[k][j];
      const std::string where = "tick " + std::to_string(ticks[k]) + ", joint " + std::to_string(j + 1) + ": ";
      if (!(q >= position_min[j] - kPositionTolerance && q <= position_max[j] + kPositionTolerance))
        places.push_back(where + "position " + std::to_string(q));
      if (!(std::abs(v) <= velocity_max[j] * (1 + tolerance)))
        places.push_back(where + "velocity " + std::to_string(v) + ", limit " + std::to_string(velocity_max[j]));
    }
  }
  return places;
}

std::map<std::string, Motion> read_motion(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(file.string() + ": cannot be read, expected a motion file");
  std::map<std::string, Motion> motions;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (stream.eof()) break;  // no end of line: the line is unfinished
    std::istringstream words(line);
    std::string mark, what;
    if (line.starts_with("# limits ")) {
      words >> mark >> what;
      read_limits(words, motions);
    } else if (!read_tick(words, motions)) {
      throw std::runtime_error(file.string() + ":" + std::to_string(number) + ": '" + line +
                               "', expected tick, robot, brakes, positions, velocities");
    }
  }
  return motions;
}

}  // namespace mrroc::task_test
