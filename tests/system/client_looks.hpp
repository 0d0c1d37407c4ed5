#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mrroc::test {

/// Ticks from one reading of the sensor "free" to the next.
inline constexpr double kPublished = 20;
/// The clients of both sensors, and the number of steps between their requests for a reading of "shared".
inline const std::map<std::string, int> kPeriods{{"mp", 1}, {"left", 3}, {"right", 5}};
/// The lines of a sensor's table that make it measure the time.
inline constexpr const char* kTime = "type = \"time\"\n";

/// TOML of a deployment of two belts whose programs, like the MP's, are tests/system/programs/several_clients_*.cpp.
/// `shared` and `free`: the lines of the sensors' tables that define the measured value.
std::string clients_deployment(const std::string& name, const std::string& shared, const std::string& free);

/// The number behind the first `word` in a program's output. Throws std::runtime_error when it is missing.
double number_after(const std::string& output, const std::string& word);

/// A client's data of a step: the ticks of its readings, and the first value of "shared".
struct Look {
  double step = 0;
  double own = 0;  ///< tick at which the step's readings are due: that of the robot, 10 ticks a step without one
  double shared = 0, value = 0, free = 0;
};

/// By client, in the order of their steps: the steps of all instructions, except those that an error ended.
std::map<std::string, std::vector<Look>> looks_of(const std::filesystem::path& trace);

}  // namespace mrroc::test
