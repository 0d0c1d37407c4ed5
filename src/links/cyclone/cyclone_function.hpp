#pragma once

#include <dlfcn.h>

namespace mrroc::links {

/// Cyclone's own function of this name, for our function that the dynamic linker finds first; null when Cyclone has no
/// such function.
template <class Function>
Function cyclone_function(const char* name) noexcept {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

}  // namespace mrroc::links
