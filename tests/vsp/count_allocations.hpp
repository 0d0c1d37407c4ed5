#pragma once

#include <cstddef>

/// Calls of operator new by this thread so far; link count_allocations.cpp.
std::size_t allocations() noexcept;
