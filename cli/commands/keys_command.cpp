#include "cli/commands/keys_command.hpp"

#include <filesystem>
#include <memory>
#include <string>

#include "cli/keys/key_maker.hpp"
#include "command/print.hpp"
#include "config/entries/device_name.hpp"
#include "config/text/deployment_text.hpp"

namespace mrroc::cli {

namespace {

/// The deployment's name alone: the file may name the keys that this command makes, and would be refused as a whole.
std::string name_of_deployment(const std::filesystem::path& file) {
  const config::DeploymentText source = config::read_deployment_text(file);
  const config::Table general =
      config::Table::parse(source.is_file ? file : source.file, source.text).table("deployment");
  std::string name = general.text("name");
  config::check_name(general, "name", name);
  return name;
}

void keys(const std::filesystem::path& folder, const std::filesystem::path& file) {
  const std::string deployment = file.empty() ? "" : name_of_deployment(file);
  make_keys(folder, deployment);
  command::print(
      folder.string() + ": keys for " + (deployment.empty() ? "any deployment" : "deployment " + deployment) +
      "\nname them in the deployment file as `keys` of [network]; anyone with a copy can command the robots\n");
}

}  // namespace

void add_keys_command(CLI::App& app, int& exit_code) {
  struct Arguments {
    std::filesystem::path folder;
    std::filesystem::path deployment;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("keys", "Make the keys that authenticate a deployment's processes");
  command->add_option("FOLDER", arguments->folder, "Folder to make; it must not exist yet")->required();
  command->add_option("--deployment", arguments->deployment,
                      "Deployment file (TOML): the keys are valid for its topics only");
  command->callback([arguments, &exit_code] {
    keys(arguments->folder, arguments->deployment);
    exit_code = 0;
  });
}

}  // namespace mrroc::cli
