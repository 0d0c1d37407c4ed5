#pragma once

#include <filesystem>
#include <string>

namespace mrroc::cli {

/// Makes a deployment's keys (links::KeyFiles) in the new folder `folder`: one identity for all of its processes, valid
/// for the topics below `<deployment>/` only, or for those of any deployment when `deployment` is empty; and the rules
/// that processes ignore participants without it and sign every message. The key that signed them is deleted: no
/// identity can be added later. They are valid from 2000 to 2099, so that a machine whose clock is wrong starts too.
/// Folder mode 0700, files 0600. Throws std::runtime_error when the folder exists already, or cannot be made or filled;
/// files made until then are removed.
void make_keys(const std::filesystem::path& folder, const std::string& deployment);

}  // namespace mrroc::cli
