#include "cli/robot/import/new_folder.hpp"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <span>
#include <string>
#include <system_error>

#include "command/write_file.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::cli {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_folder(const fs::path& folder, const std::string& reason) {
  throw SystemError(ErrorCode::resources, "cannot make folder " + folder.string() + ": " + reason);
}

}  // namespace

NewFolder::NewFolder(fs::path target) : target_(std::move(target)) {
  std::error_code problem;
  fs::create_directories(target_.parent_path(), problem);
  if (problem) refuse_folder(target_.parent_path(), problem.message());
  std::string pattern = target_.parent_path() / ("." + target_.filename().string() + ".XXXXXX");
  if (::mkdtemp(pattern.data()) == nullptr) refuse_folder(pattern, std::strerror(errno));
  path_ = pattern;
  fs::permissions(path_, fs::perms(0755), problem);
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

void NewFolder::write(const std::string& name, std::string_view text) const {
  command::write_file(path_ / name, std::as_bytes(std::span(text)));
}

void NewFolder::keep() {
  std::error_code problem;
  const fs::path old = path_.string() + ".old";
  if (fs::exists(target_)) fs::rename(target_, old, problem);
  if (!problem) fs::rename(path_, target_, problem);
  if (problem) {
    std::error_code ignored;
    if (fs::exists(old)) fs::rename(old, target_, ignored);
    refuse_folder(target_, problem.message());
  }
  path_.clear();
  fs::remove_all(old, problem);
}

}  // namespace mrroc::cli
