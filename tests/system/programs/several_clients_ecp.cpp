// A belt whose program uses sensors that other programs use, too: "left" and "right" differ in their macrosteps, in the
// period of their readings, and in the process that sets the zero.
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
      Wait({belt}, {}, ElapsedSteps{100});  // the others receive it, too
      throw;
    }
  }
};

}  // namespace

MRROC_ECP(SeveralClients)
