#include "config/drives/node_objects.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "canopen/object_value.hpp"
#include "config/entries/named_file.hpp"
#include "config/resources.hpp"
#include "config/text/file_text.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

/// An error that another part of the framework reports: "<problem>, expected <what>", or the problem alone.
[[noreturn]] void fail_with(const Table& table, const std::string& key, const std::string& message,
                            const std::string& usual) {
  constexpr std::string_view kExpected = ", expected ";
  const std::size_t at = message.find(kExpected);
  if (at == std::string::npos) table.fail(key, message, usual);
  table.fail(key, message.substr(0, at), message.substr(at + kExpected.size()));
}

NodeSetting read_setting(const Table& table, const std::string& key, const canopen::EdsFile& eds,
                         const CheckObject& check) {
  NodeSetting setting;
  setting.name = key;
  try {
    setting.object = eds.object(key);
  } catch (const std::invalid_argument& error) {
    fail_with(table, key, error.what(), "an object of the node");
  }
  const canopen::ObjectEntry& entry = *eds.find(setting.object);
  if (!entry.writable()) table.fail(key, "may only be read", "an object that may be written");
  check(table, key, setting.object);
  const std::size_t size = canopen::size_of(entry.type);
  if (size == 0 || entry.type == canopen::DataType::real32)
    table.fail(key, "is not of an integer type", "an object with an integer");
  setting.value = table.integer(key, canopen::least(entry.type), canopen::greatest(entry.type));
  setting.size = static_cast<std::uint8_t>(size);
  return setting;
}

}  // namespace

std::filesystem::path eds_file(const Table& table, const std::string& general) {
  const std::string name = table.text("eds");
  std::filesystem::path file = beside(table.file(), name);
  for (const std::filesystem::path& share : share_directories())
    if (!std::filesystem::exists(file)) file = share / "canopen" / "standard" / name;
  if (!std::filesystem::exists(file))
    table.fail("eds", in_quotes(name) + " is not there", "an EDS file beside this one, or " + in_quotes(general));
  return file;
}

canopen::EdsFile load_eds(const Table& table, const std::string& general) {
  const std::filesystem::path file = eds_file(table, general);
  if (const std::string problem = reading_problem(file); !problem.empty())
    table.fail("eds", in_quotes(table.text("eds")) + " " + problem, "an EDS file of CiA 306");
  try {
    return canopen::EdsFile::load(file);
  } catch (const canopen::EdsError& error) {
    fail_with(table, "eds", error.what(), "an EDS file of CiA 306");
  }
}

void read_settings(const Table& owner, const canopen::EdsFile& eds, const CheckObject& check,
                   std::vector<NodeSetting>& settings) {
  const auto table = owner.optional_table("objects");
  if (!table) return;
  std::vector<NodeSetting> own;
  for (const std::string& key : table->keys()) {
    own.push_back(read_setting(*table, key, eds, check));
    const auto same = [&own](const NodeSetting& setting) { return setting.object == own.back().object; };
    if (const auto earlier = std::find_if(own.begin(), own.end() - 1, same); earlier != own.end() - 1)
      table->fail(key, "is the object of " + in_quotes(earlier->name), "each object once");
  }
  settings.insert(settings.end(), own.begin(), own.end());
  table->finish();
}

}  // namespace mrroc::config
