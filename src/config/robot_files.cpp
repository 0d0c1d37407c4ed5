#include "config/robot_files.hpp"

#include "config/entries/named_file.hpp"
#include "config/resources.hpp"
#include "config/robot_parameters_file.hpp"
#include "config/table.hpp"
#include "config/text/file_text.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace fs = std::filesystem;

RobotFiles robot_files(const std::string& type, const fs::path& parameters) {
  const fs::path own = type_file("robots", type, type);
  if (parameters.empty()) {
    const std::string stem = own.string();
    return {stem + ".toml", stem + ".xml", stem + ".urdf", stem + "_drives.toml"};
  }
  const std::string stem = (parameters.parent_path() / parameters.stem()).string();
  const auto beside_or_own = [&](const std::string& ending) {
    return fs::exists(stem + ending) ? fs::path(stem + ending) : fs::path(own.string() + ending);
  };
  // the type's URDF contains the limits of the type's own parameters
  return {parameters, beside_or_own(".xml"), stem + ".urdf", beside_or_own("_drives.toml")};
}

fs::path parameter_file(const std::string& type, const fs::path& parameters) {
  return parameters.empty() ? type_file("robots", type, type + ".toml") : parameters;
}

void refuse_parameters(const fs::path& parameters) {
  if (parameters.empty()) return;
  throw ConfigurationError(parameters, 0, "", "the EDP of this robot's type reads the type's own parameters only",
                           "no such key in the deployment, or an EDP that loads a given file");
}

fs::path find_parameters(const Table& table, const std::string& type) {
  const std::string name = table.text("parameters");
  const fs::path here = beside(table.file(), name), own = type_file("robots", type, name);
  const bool plain = fs::path(name).filename() == name;
  const fs::path& found = plain && !fs::exists(here) && fs::exists(own) ? own : here;
  if (const std::string problem = reading_problem(found); !problem.empty()) {
    table.fail("parameters", in_quotes(name) + " " + problem,
               "a readable file " + here.string() + (plain ? " or " + own.string() : ""));
  }
  const std::string read = read_robot_parameters(Table::load(found)).type;
  if (read != type)
    table.fail("parameters", in_quotes(name) + " is of type " + in_quotes(read), "parameters of a " + in_quotes(type));
  return found;
}

}  // namespace mrroc::config
