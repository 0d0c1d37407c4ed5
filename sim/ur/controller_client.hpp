#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "drivers/ur/rtde/packet.hpp"
#include "drivers/ur/rtde/recipe.hpp"
#include "sim/ur/controller_servers.hpp"

namespace mrroc::sim::ur {

/// One connection of a client to one of the servers. The servers' thread, under their mutex.
struct ControllerServers::Client {
  Service service;
  int fd;
  std::vector<std::uint8_t> queued;
  bool ended = false;
  // RTDE
  mrroc::ur::rtde::PacketBuffer packets;
  bool started = false;
  std::uint64_t every = 0;  ///< periods between two data packages
  std::vector<const VirtualController::Getter*> outputs;
  mrroc::ur::rtde::Recipe output_recipe;
  struct InputRecipe {
    mrroc::ur::rtde::Recipe recipe;
    std::vector<std::string> names;
    std::vector<const VirtualController::Input*> fields;
  };
  std::map<std::uint8_t, InputRecipe> inputs;
  bool drives = false;  ///< lockstep: it writes the set-points
  struct Held {
    std::uint64_t due;  ///< period of the controller
    std::vector<std::uint8_t> bytes;
  };
  std::deque<Held> held;  ///< packages that are delayed
  // the others
  std::string text;
};

}  // namespace mrroc::sim::ur
