#pragma once

#include <functional>
#include <string>
#include <vector>

#include "driver_faults/cell.hpp"

namespace mrroc::driver_faults {

/// A trouble of a device or of the network to it, and the end of it.
struct Trouble {
  std::string name;
  std::function<void(Cell&)> begin;
  std::function<void(Cell&)> end;
};

const std::vector<Trouble>& troubles();

}  // namespace mrroc::driver_faults
