#include "cli/panel/page_files.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace mrroc::cli {

namespace {

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::string media_type(const std::filesystem::path& name) {
  const std::string extension = name.extension().string();
  if (extension == ".html") return "text/html; charset=utf-8";
  if (extension == ".js") return "text/javascript; charset=utf-8";
  if (extension == ".css") return "text/css; charset=utf-8";
  if (extension == ".json") return "application/json";
  if (extension == ".png") return "image/png";
  if (extension == ".svg") return "image/svg+xml";
  return "text/plain; charset=utf-8";
}

std::map<std::string, PageFile> load_page(const std::filesystem::path& folder) {
  std::map<std::string, PageFile> files;
  std::error_code problem;
  for (const auto& entry : std::filesystem::directory_iterator(folder, problem)) {
    const std::filesystem::path& path = entry.path();
    if (path.extension() == ".gz")
      files[path.stem().string()].compressed = content_of(path);
    else
      files[path.filename().string()].content = content_of(path);
  }
  for (auto& [name, file] : files) file.type = media_type(name);
  if (!files.contains("index.html"))
    throw std::runtime_error("no page in " + folder.string() + ", expected index.html of 'make panel'");
  return files;
}

}  // namespace mrroc::cli
