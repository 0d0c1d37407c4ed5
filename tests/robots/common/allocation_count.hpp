#pragma once

namespace mrroc {

/// Allocations of this process so far that its own code asked for, by operator new or by malloc (as Eigen does).
long allocation_count() noexcept;

}  // namespace mrroc
