#include "mp/state_machine_task.hpp"
#include "process/build_scope.hpp"

namespace {

using namespace mrroc;

/// Starts every ECP and waits until all have ended.
class Stock : public mp::Task {
  void run() override {
    start_all();
    wait_for_all();
  }
};

/// The stock MP: the state machine that the deployment names, or all ECPs at once.
std::unique_ptr<mp::Task> make_task() {
  if (process::BuildScope::process().deployment().mp.states.empty()) return std::make_unique<Stock>();
  return std::make_unique<mp::StateMachineTask>();
}

}  // namespace

int main(int argc, char** argv) { return mrroc::mp::run(argc, argv, make_task); }
