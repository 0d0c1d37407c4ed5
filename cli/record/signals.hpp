#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mrroc::cli::record {

/// The values of one number of a topic's messages, in their order.
struct Signal {
  std::string name;           ///< "/arm/servo/current[2]"
  std::vector<double> times;  ///< of the messages, s
  std::vector<double> values;
};

/// The time of the run that is looked at, s.
struct TimeSpan {
  double from = 0;
  double to = 1e300;
};

/// The signals below each name: "/TOPIC/FIELD", "/TOPIC/FIELD[2]", "/TOPIC/FIELD.FIELD" (or with `/` in place of `.`);
/// a field that has several numbers has a signal for each, a topic all of its numbers. Truth values are 0 and 1; a
/// number that is not finite has no value, stamps are no signals. Throws std::runtime_error "FILE: ..." when the file
/// cannot be read, or has no such signal.
std::vector<std::vector<Signal>> read_signals(const std::filesystem::path& file, const std::vector<std::string>& names,
                                              const TimeSpan& span);

/// The names of all fields with numbers, as `read_signals` takes them, in the order of topics and fields; those of a
/// list without its indices. Throws std::runtime_error "FILE: ...".
std::vector<std::string> signal_names(const std::filesystem::path& file);

}  // namespace mrroc::cli::record
