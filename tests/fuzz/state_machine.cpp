// Output of ECP programs for `--behaviours`, then the line "====", then a state-machine file for them.
#include "config/state_machine.hpp"

#include <stdexcept>

#include "config/table.hpp"
#include "fuzz/fuzz.hpp"
#include "fuzz/memory_file.hpp"

namespace {

mrroc::config::Deployment two_robots() {
  mrroc::config::Deployment deployment;
  for (const char* name : {"arm", "belt"}) {
    mrroc::config::RobotEntry robot;
    robot.name = name;
    deployment.robots.push_back(robot);
  }
  return deployment;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  static const mrroc::config::Deployment deployment = two_robots();
  fuzz::Bytes input(data, size);
  mrroc::config::ProgramsByRobot programs;
  const std::string output{input.take_section()};
  if (fuzz::refuses<std::runtime_error>([&] { programs = mrroc::config::read_programs(output); })) return 0;
  const std::string text = mrroc::config::to_text(programs);
  fuzz::require(mrroc::config::to_text(mrroc::config::read_programs(text)) == text, "behaviours round-trip as text");
  fuzz::refuses<mrroc::config::ConfigurationError>([&] {
    const auto machine = mrroc::config::load_state_machine(file.write(input.rest()), deployment, programs);
    fuzz::require(!mrroc::config::to_dot(machine).empty(), "a state machine can be drawn");
    for (const auto& state : machine.states)
      for (const auto& start : state.starts)
        fuzz::require(start.behaviour.size <= mrroc::Message::kCapacity, "a behaviour fits its message");
  });
  return 0;
}
