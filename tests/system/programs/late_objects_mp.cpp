// An MP that makes robots and sensors while it runs, or has an ECP make them.
#include "late_objects.hpp"
#include "mrroc/mp.hpp"

using namespace mrroc;

namespace {

class Late : public mp::Task {
  test::LateObjects objects_{*this, "belt"};

  void run() override {
    if (objects_.kind() == "in_behaviour")
      perform("belt", test::Make{});
    else if (objects_.kind() == "in_part")
      concurrently({[this] { objects_.use_sensor("clock"); }});
    else
      objects_.make();
  }
};

}  // namespace

MRROC_MP(Late)
