#pragma once

#include <cstddef>

/// Calls of operator new, in any of its forms, by this thread so far; link count_allocations.cpp.
std::size_t allocations() noexcept;
