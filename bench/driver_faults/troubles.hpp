#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "driver_faults/device.hpp"

namespace mrroc::driver_faults {

/// A trouble of a device or of the network to it, and the end of it.
struct Trouble {
  std::string name;
  std::function<std::unique_ptr<Device>()> make;
  std::function<void(Device&)> begin;
  std::function<void(Device&)> end;
};

const std::vector<Trouble>& troubles();

}  // namespace mrroc::driver_faults
