#pragma once

#include <cstddef>

namespace mrroc::cli {

/// Raises the limit of open files as far as it may be, and checks it and the file size limit, which counts for shared
/// memory, too: for this process, and for the `processes` that it starts, which inherit both. Throws
/// SystemError(resources) that names the limit, its value and what was expected. Main thread, before anything starts.
void check_limits(std::size_t processes);

}  // namespace mrroc::cli
