// A belt whose program looks at sensors that others use, too: "left" and "right" differ in their macrosteps, in how
// often they look, and in who takes the zero.
#include <cstdio>

#include "mrroc/ecp.hpp"
#include "mrroc/robots/conveyor.hpp"
#include "several_clients.hpp"

using namespace mrroc;

namespace {

class SeveralClients : public ecp::Task {
  Conveyor belt{*this};
  test::Client client{*this};

  void run() override {
    const bool left = process_name() == "left";
    belt.set_macrostep(left ? 7 : 10, left ? 5 : 10);  // the replies of "right" come at the MP's ticks
    try {
      client.run({belt}, left ? 3 : 5, left ? 2 : 0);
    } catch (const Error& error) {
      std::printf("met %s\n", error.what());
      Wait({belt}, {}, ElapsedSteps{100});  // the others meet it, too
      throw;
    }
  }
};

}  // namespace

MRROC_ECP(SeveralClients)
