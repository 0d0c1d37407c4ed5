#include "process/build_scope.hpp"

#include <stdexcept>

namespace mrroc::process {

namespace {
thread_local Process* current = nullptr;
}

BuildScope::BuildScope(Process& process) noexcept : outer_(current) { current = &process; }

BuildScope::~BuildScope() { current = outer_; }

Process& BuildScope::process() {
  if (current == nullptr)
    throw std::logic_error("a task object is built by the framework (MRROC_ECP, MRROC_MP), not by hand");
  return *current;
}

}  // namespace mrroc::process
