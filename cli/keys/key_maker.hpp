#pragma once

#include <filesystem>
#include <string>

namespace mrroc::cli {

/// Makes a deployment's keys (links::KeyFiles) in the new folder `folder`: one identity for all of its processes, which
/// may use the topics below `<deployment>/` and no others, of any deployment when `deployment` is empty; and the rules
/// that no one without it is talked to and that every message is signed. The key that signed them is thrown away:
/// no one can add an identity later. They are valid from 2000 to 2099, so that a machine whose clock is wrong starts
/// too. Folder mode 0700, files 0600. Throws std::runtime_error: the folder is there already, cannot be made or filled;
/// what was begun is removed.
void make_keys(const std::filesystem::path& folder, const std::string& deployment);

}  // namespace mrroc::cli
