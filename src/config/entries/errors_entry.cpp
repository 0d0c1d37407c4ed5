#include "config/entries/errors_entry.hpp"

#include <limits>
#include <string>

#include "config/entries/named_file.hpp"
#include "config/resources.hpp"
#include "config/text/file_text.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

void read_sizes(const Table& table, ErrorsEntry& errors) {
  for (const ErrorKey& key : error_keys()) errors.*key.size = table.number_or(key.name, errors.*key.size, {0, key.max});
}

bool is_path(const std::string& name) { return name.find('/') != std::string::npos || name.ends_with(".toml"); }

std::filesystem::path find_set(const Table& table, const std::string& name) {
  if (is_path(name)) return require_file(table, "set");
  std::filesystem::path file = errors_set(name);
  if (!reading_problem(file).empty())
    table.fail("set", "no set " + in_quotes(name), "a readable file " + file.string() + ", or a path");
  return file;
}

}  // namespace

const std::array<ErrorKey, 25>& error_keys() {
  using Errors = ErrorsEntry;
  static constexpr std::array<ErrorKey, 25> keys{{
      {"base_position", &Errors::base_position, 0.1},
      {"base_rotation", &Errors::base_rotation, 0.2},
      {"link_position", &Errors::link_position, 0.02},
      {"link_rotation", &Errors::link_rotation, 0.05},
      {"joint_offset", &Errors::joint_offset, 0.1},
      {"gear_ratio", &Errors::gear_ratio, 0.05},
      {"eccentricity", &Errors::eccentricity, 0.05},
      {"backlash", &Errors::backlash, 0.05},
      {"friction", &Errors::friction, 0.5},
      {"current_noise", &Errors::current_noise, 0.5},
      {"force_noise", &Errors::force_noise, 100},
      {"torque_noise", &Errors::torque_noise, 10},
      {"force_bias", &Errors::force_bias, 100},
      {"torque_bias", &Errors::torque_bias, 10},
      {"force_drift", &Errors::force_drift, 10},
      {"torque_drift", &Errors::torque_drift, 1},
      {"range_noise", &Errors::range_noise, 1},
      {"camera_position", &Errors::camera_position, 0.1},
      {"camera_rotation", &Errors::camera_rotation, 0.2},
      {"focal_length", &Errors::focal_length, 0.2},
      {"distortion", &Errors::distortion, 0.5},
      {"pixel_noise", &Errors::pixel_noise, 100},
      {"blur", &Errors::blur, 10},
      {"camera_latency", &Errors::camera_latency, 1},
      {"shadow", &Errors::shadow, 1},
  }};
  return keys;
}

std::filesystem::path errors_set(const std::string& name) {
  return is_path(name) ? std::filesystem::path(name) : type_file("sim", "errors", name + ".toml");
}

ErrorsEntry read_errors(const Table& table) {
  ErrorsEntry errors;
  if (const auto name = table.optional_text("set")) {
    const Table set = Table::load(find_set(table, *name));
    read_sizes(set, errors);
    set.finish();
  }
  errors.seed =
      static_cast<std::uint32_t>(table.integer_or("seed", errors.seed, 0, std::numeric_limits<std::uint32_t>::max()));
  read_sizes(table, errors);
  table.finish();
  return errors;
}

}  // namespace mrroc::config
