#include "cli/commands/errors_option.hpp"

#include <algorithm>

#include "config/entries/errors_entry.hpp"
#include "config/table.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::cli {

namespace {

/// Whether it can stand in a literal string of TOML.
bool is_literal(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return c == '\'' || byte < 0x20 || byte == 0x7F;
  });
}

}  // namespace

std::string errors_table(const std::filesystem::path& file, const config::Deployment& deployment,
                         const std::string& name, std::uint32_t seed) {
  const auto refuse = [&file](const std::string& problem, const std::string& expected) {
    throw config::ConfigurationError(file, 0, "--errors", problem, expected);
  };
  if (!deployment.sim) refuse("the deployment simulates no world", "a table [sim]");
  if (deployment.sim->errors) refuse("the deployment has a table [sim.errors]", "a deployment without one");
  const std::filesystem::path set = std::filesystem::absolute(config::errors_set(name));
  if (name.empty() || !is_literal(set.string()) || !std::filesystem::is_regular_file(set))
    refuse("no set of errors " + config::in_quotes(name), "'modest', or a file with sizes");
  return "\n[sim.errors]  # --errors\nset = '" + set.string() + "'\nseed = " + std::to_string(seed) + "\n";
}

}  // namespace mrroc::cli
