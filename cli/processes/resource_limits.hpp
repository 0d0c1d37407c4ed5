#pragma once

#include <cstddef>

namespace mrroc::cli {

/// Raises the limit of open files as far as allowed, and checks it and the file size limit, which also counts for
/// shared memory: for this process, and for the `processes` that it starts, which inherit both.
/// `recorded`: bytes of the memory in which one of them passes on what is recorded; 0: nothing is. Throws
/// SystemError(resources) that names the limit, its value and the expected value. Main thread, before anything starts.
void check_limits(std::size_t processes, std::size_t recorded);

}  // namespace mrroc::cli
