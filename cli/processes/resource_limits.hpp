#pragma once

#include <cstddef>

namespace mrroc::cli {

/// Raises the limit of open files as far as allowed, and checks it and the file size limit, which also counts for
/// shared memory: for this process, and for the `processes` that it starts, which inherit both. Throws
/// SystemError(resources) that names the limit, its value and the expected value. Main thread, before anything starts.
void check_limits(std::size_t processes);

}  // namespace mrroc::cli
