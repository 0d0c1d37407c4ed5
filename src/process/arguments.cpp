#include "process/arguments.hpp"

#include <CLI/CLI.hpp>
#include <sstream>
#include <stdexcept>

#include "command/print.hpp"
#include "command/version.hpp"

namespace mrroc::process {

std::vector<std::string> to_command_line(const Arguments& arguments) {
  std::vector<std::string> words{
      "--deployment", arguments.deployment.string(),      "--name",   arguments.name,
      "--clock-fd",   std::to_string(arguments.clock_fd), "--domain", std::to_string(arguments.domain)};
  const auto add = [&words](const char* option, const std::string& value) {
    words.emplace_back(option);
    words.push_back(value);
  };
  if (arguments.world_fd >= 0) add("--world-fd", std::to_string(arguments.world_fd));
  if (arguments.deployment_fd >= 0) add("--deployment-fd", std::to_string(arguments.deployment_fd));
  if (arguments.record_fd >= 0) add("--record-fd", std::to_string(arguments.record_fd));
  if (!arguments.behaviours.empty()) add("--behaviours-of-programs", arguments.behaviours);
  if (!arguments.black_box.empty()) add("--black-box", arguments.black_box.string());
  if (arguments.black_box_fd >= 0) add("--black-box-fd", std::to_string(arguments.black_box_fd));
  if (arguments.picture_fd >= 0) add("--picture-fd", std::to_string(arguments.picture_fd));
  if (!arguments.snapshots.empty()) add("--snapshots", arguments.snapshots.string());
  if (!arguments.motion.empty()) add("--motion", arguments.motion.string());
  if (arguments.motion_fd >= 0) add("--motion-fd", std::to_string(arguments.motion_fd));
  for (const std::string& fault : arguments.faults) add("--inject", fault);
  if (!arguments.interface.empty()) add("--interface", arguments.interface);
  for (const std::string& peer : arguments.peers) add("--peers", peer);
  if (!arguments.keys.empty()) add("--keys", arguments.keys.string());
  return words;
}

std::vector<int> Arguments::descriptors() const {
  std::vector<int> handed;
  for (const int fd : {clock_fd, world_fd, black_box_fd, deployment_fd, motion_fd, record_fd, picture_fd})
    if (fd >= 0) handed.push_back(fd);
  return handed;
}

std::optional<Arguments> parse_arguments(int argc, char** argv) {
  Arguments arguments;
  CLI::App app{"A process of an MRROC++ deployment. It is started by `mrroc run FILE`, not by hand."};
  app.name(std::filesystem::path(argv[0]).filename().string());
  app.set_version_flag("--version", command::version_text(app.get_name()), "Print the version and exit");
  app.add_option("--deployment", arguments.deployment)->required();
  app.add_option("--name", arguments.name)->required();
  app.add_option("--clock-fd", arguments.clock_fd)->required();
  app.add_option("--world-fd", arguments.world_fd);
  app.add_option("--domain", arguments.domain)->required();
  app.add_option("--deployment-fd", arguments.deployment_fd);
  app.add_option("--record-fd", arguments.record_fd);
  app.add_option("--behaviours-of-programs", arguments.behaviours);
  app.add_option("--black-box", arguments.black_box);
  app.add_option("--black-box-fd", arguments.black_box_fd);
  app.add_option("--picture-fd", arguments.picture_fd);
  app.add_option("--snapshots", arguments.snapshots);
  app.add_option("--motion", arguments.motion);
  app.add_option("--motion-fd", arguments.motion_fd);
  app.add_option("--inject", arguments.faults)->take_all()->expected(1);
  app.add_option("--interface", arguments.interface);
  app.add_option("--peers", arguments.peers);
  app.add_option("--keys", arguments.keys);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    std::ostringstream text;
    app.exit(asked, text, text);
    command::print(text.str());
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw std::runtime_error(std::string{error.what()} + "; this program is started by `mrroc run FILE`");
  }
  return arguments;
}

}  // namespace mrroc::process
