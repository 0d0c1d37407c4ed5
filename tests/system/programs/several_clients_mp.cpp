// Reads the sensors that the programs of its robots use at the same time.
#include <cstdio>

#include "mrroc/mp.hpp"
#include "several_clients.hpp"

using namespace mrroc;

namespace {

class SeveralClients : public mp::Task {
  test::Client client{*this};

  void run() override {
    start_all();
    try {
      client.run({}, 1, 1);
    } catch (const Error& error) {
      std::printf("met %s\n", error.what());
      wait_for_all();
      throw;
    }
    wait_for_all();
  }
};

}  // namespace

MRROC_MP(SeveralClients)
