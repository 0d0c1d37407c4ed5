#include "plugin/plugin.hpp"

#include <dlfcn.h>

#include <string>

#include "mrroc/errors.hpp"

namespace mrroc::plugin {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& library, const std::string& problem) {
  throw SystemError(ErrorCode::configuration, library.string() + ": " + problem);
}

/// The linker's words without the path, which `refuse` gives.
std::string linker_problem(const std::filesystem::path& library) {
  const char* const text = ::dlerror();
  std::string problem = text != nullptr ? text : "cannot be loaded";
  const std::string start = library.string() + ": ";
  return problem.starts_with(start) ? problem.substr(start.size()) : problem;
}

}  // namespace

const Interface& load(const std::filesystem::path& library, const Interface& expected) {
  void* const handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) refuse(library, linker_problem(library) + ", expected a shared library");
  const auto* const found = static_cast<const Interface*>(::dlsym(handle, "mrroc_plugin"));
  if (found == nullptr) refuse(library, std::string("exports no symbol mrroc_plugin, expected a ") + expected.kind);
  if (found->kind == nullptr || std::string_view(found->kind) != expected.kind)
    refuse(library, std::string(found->kind != nullptr ? found->kind : "nothing") + ", expected a " + expected.kind);
  if (found->version != expected.version)
    refuse(library, std::string("made for version ") + std::to_string(found->version) + " of the interface, expected " +
                        std::to_string(expected.version) + ": build it with this release");
  if (found->layout != expected.layout)
    refuse(library,
           "it and this program were not made with the same headers, expected those of one release: build both again");
  if (found->make == nullptr) refuse(library, "its interface has no function");
  return *found;
}

}  // namespace mrroc::plugin
