// The answer of an HTTP server of any content, and the configuration page in it.
#include <cmath>

#include "config/table.hpp"
#include "drivers/netft/calibration.hpp"
#include "drivers/netft/http_get.hpp"
#include "fuzz/fuzz.hpp"
#include "mrroc/errors.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mrroc;
  const std::string answer(fuzz::text_of(data, size));
  std::string page = answer;
  fuzz::refuses<HardwareError>([&] {
    page = netft::body_of(answer, "http://sensor");
    fuzz::require(page.size() <= answer.size(), "a body is a part of its answer");
  });
  fuzz::refuses<config::ConfigurationError>([&] {
    const netft::SensorConfiguration read = netft::read_configuration(page, "http://sensor");
    fuzz::require(std::isnormal(read.calibration.newtons_per_count) && read.calibration.newtons_per_count > 0,
                  "counts have a force");
    fuzz::require(
        std::isnormal(read.calibration.newton_metres_per_count) && read.calibration.newton_metres_per_count > 0,
        "counts have a torque");
  });
  return 0;
}
