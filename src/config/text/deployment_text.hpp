#pragma once

#include <filesystem>
#include <string>

namespace mrroc::config {

/// The text of a deployment, read once.
struct DeploymentText {
  /// The name in messages; relative paths of the deployment start at its folder. Of a regular file its absolute path;
  /// otherwise in the working directory: `stdin`, `fd-3`, or the name of the FIFO.
  std::filesystem::path file;
  std::string text;
  bool is_file = true;      ///< false: it cannot be read again
  bool from_stdin = false;  ///< the standard input has been consumed
};

/// Reads `file`; `-` is the standard input. A file that is not a regular one, a FIFO or `/dev/fd/N`, is read up to its
/// end, at most 16 MiB. Throws ConfigurationError when it cannot be read. Configuration time only.
DeploymentText read_deployment_text(const std::filesystem::path& file);

}  // namespace mrroc::config
