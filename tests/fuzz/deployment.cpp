// A deployment file of the stock robot and sensor types, with every stock program, a scene, a replay file and a state
// machine beside it.
#include "config/deployment.hpp"

#include <netdb.h>
#include <stdlib.h>

#include <cmath>

#include "config/description.hpp"
#include "config/resources.hpp"
#include "config/table.hpp"
#include "fuzz/fuzz.hpp"
#include "mrroc/testing/scratch_folder.hpp"

/// Host names are not resolved, because an input must not access the network. (The linker replaces getaddrinfo with
/// it.)
extern "C" int __real_getaddrinfo(const char*, const char*, const addrinfo*, addrinfo**);
extern "C" int __wrap_getaddrinfo(const char* host, const char* service, const addrinfo*, addrinfo** list) {
  addrinfo numeric{};
  numeric.ai_flags = AI_NUMERICHOST;
  return __real_getaddrinfo(host, service, &numeric, list);
}

namespace {

struct Place {
  Place() {
    setenv("MRROC_SHARE", MRROC_BINARY_DIR "/share/mrroc", 1);
    setenv("MRROC_PROGRAMS", folder.path().c_str(), 1);
    for (const char* name : {"mrroc_mp", "mrroc_ecp", "mrroc_sim"}) program(name);
    for (const std::string& type : mrroc::config::robot_types()) program(type + "_edp");
    for (const std::string& type : mrroc::config::sensor_types()) program(type + "_vsp");
    for (const char* name : {"scene.xml", "readings.txt", "states.toml"}) folder.write(name, "");
  }
  void program(const std::string& name) const {
    std::filesystem::permissions(folder.write(name, ""), std::filesystem::perms::owner_all);
  }
  mrroc::task_test::ScratchFolder folder;
};

void check(const mrroc::config::Deployment& deployment) {
  fuzz::require(!mrroc::config::describe(deployment).empty(), "a deployment has a description");
  for (const auto& sensor : deployment.sensors) {
    const double periods = 1 / (sensor.rate * deployment.servo_period);
    fuzz::require(sensor.interactive || (std::round(periods) >= 1 && periods < 1.1e9),
                  "a rate is a representable number of servo periods");
  }
  for (const auto& robot : deployment.robots) {
    fuzz::require(robot.base.matrix().allFinite(), "the base of a robot is finite");
    fuzz::require(robot.force_limits.allFinite(), "force limits are numbers");
  }
  for (std::size_t i = 1; i < deployment.events.size(); ++i)
    fuzz::require(deployment.events[i - 1].tick <= deployment.events[i].tick, "events are in the order of ticks");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Place place;
  const auto file = place.folder.write("deployment.toml", fuzz::text_of(data, size));
  fuzz::refuses<mrroc::config::ConfigurationError>([&] { check(mrroc::config::load_deployment(file)); });
  return 0;
}
