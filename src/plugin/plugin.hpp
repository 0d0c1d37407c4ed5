#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>

#include "mrroc/fnv.hpp"

namespace mrroc::plugin {

/// What a plug-in exports, as the symbol `mrroc_plugin`: what it is, which headers it was compiled with, and a function
/// whose type follows from `kind` and `version`.
struct Interface {
  const char* kind;       ///< "robot driver", "sensor driver"
  std::uint32_t version;  ///< of that kind's interface
  std::uint64_t layout;   ///< `layout_of` the types that cross it
  void (*make)();
};

/// Hash of the sizes of the types that cross an interface: a plug-in that was compiled with other headers would
/// read other members.
constexpr std::uint64_t layout_of(std::initializer_list<std::uint64_t> sizes) noexcept {
  Fnv1a hash;
  for (const std::uint64_t size : sizes) hash.add(size);
  return hash.value();
}

/// Loads `library` and returns its interface, which is valid until the process ends: a library is not unloaded. Throws
/// SystemError(configuration) that names the file when it is missing, not a shared library, lacks a symbol, is not a
/// plug-in, or is of another kind, version or layout than `expected`. Main thread, at the start of a process.
const Interface& load(const std::filesystem::path& library, const Interface& expected);

}  // namespace mrroc::plugin

/// Exports the plug-in of this library; once in a library.
#define MRROC_PLUGIN(...)                                                                    \
  extern "C" {                                                                               \
  __attribute__((visibility("default"))) extern const mrroc::plugin::Interface mrroc_plugin; \
  const mrroc::plugin::Interface mrroc_plugin = __VA_ARGS__;                                 \
  }
