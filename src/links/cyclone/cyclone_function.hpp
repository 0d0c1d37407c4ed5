#pragma once

#include <dlfcn.h>

namespace mrroc::links {

/// Cyclone's own function of this name, for ours that the dynamic linker finds before it; null where it has none.
template <class Function>
Function cyclone_function(const char* name) noexcept {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

}  // namespace mrroc::links
