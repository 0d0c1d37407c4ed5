#include "can/bus.hpp"
#include "can/hub_bus.hpp"
#include "can/socket_bus.hpp"

namespace mrroc::can {

std::unique_ptr<Bus> open_bus(const std::string& name) {
  constexpr std::string_view kHub = "unix:";
  if (name.starts_with(kHub)) return std::make_unique<HubBus>(name.substr(kHub.size()));
  return std::make_unique<SocketBus>(name);
}

}  // namespace mrroc::can
