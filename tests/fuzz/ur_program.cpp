// Lines of text that clients send to the simulated UR controller: to its dashboard server, as programs, as single
// commands.
#include <cmath>
#include <string>

#include "fuzz/fuzz.hpp"
#include "sim/ur/virtual_controller.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mrroc::sim::ur;
  VirtualController controller({.powered = true}, std::make_unique<ExactJoints>(Six{}));
  fuzz::Bytes input(data, size);
  for (int sections = 0; sections < 8 && !input.empty(); ++sections) {
    const std::string text(input.take_section());
    const std::string answer = controller.dashboard(text.substr(0, text.find('\n')));
    fuzz::require(!answer.empty() && answer.find('\n') == std::string::npos, "an answer is one line");
    const bool started = controller.start_program(text);
    fuzz::require(!started || !controller.program().empty(), "a running program has a name");
    for (int i = 0; i < 20; ++i) controller.step();
  }
  for (const double value : controller.position()) fuzz::require(!std::isnan(value), "a joint has a position");
  return 0;
}
