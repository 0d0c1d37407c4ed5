#include "cli/robot/import/demo_command.hpp"

#include <algorithm>
#include <vector>

#include "config/resources.hpp"

namespace mrroc::cli {

namespace fs = std::filesystem;

std::string demo_command(const fs::path& type) {
  const fs::path folder = fs::weakly_canonical(type).parent_path();
  const fs::path share = folder.parent_path();
  std::string run = "mrroc run " + (type / "demo.toml").string();
  if (folder.filename() != "robots")
    return "move " + type.string() + " into a folder 'robots' below one that MRROC_SHARE names, then run its demo.toml";
  const std::vector<fs::path> known = config::share_directories();
  const auto is_share = [&share](const fs::path& each) { return fs::weakly_canonical(each) == share; };
  if (is_share(config::user_share()) || std::any_of(known.begin(), known.end(), is_share)) return run;
  std::string list = share.string();
  for (const fs::path& each : known) list += ":" + each.string();
  return "MRROC_SHARE=" + list + " " + run;
}

}  // namespace mrroc::cli
