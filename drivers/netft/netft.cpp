#include "drivers/netft/netft_source.hpp"
#include "vsp/driver.hpp"

namespace {

using namespace mrroc;

std::unique_ptr<vsp::Source> make(const vsp::SourceContext& context) {
  const config::DriverEntry& driver = *context.entry.driver;
  return netft::open_netft(netft::netft_options(context.entry, driver), context);
}

}  // namespace

MRROC_SENSOR_DRIVER(make)
