#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace mrroc::cli {

/// One file of the panel's page, as it is and compressed (gzip, empty: not there).
struct PageFile {
  std::string type;  ///< its media type
  std::string content;
  std::string compressed;
};

/// The files in `folder` by name, without those that end in .gz: these are the compressed contents. Throws
/// std::runtime_error when there is no index.html. Any thread.
std::map<std::string, PageFile> load_page(const std::filesystem::path& folder);

/// The media type of a file name. Any thread.
std::string media_type(const std::filesystem::path& name);

}  // namespace mrroc::cli
