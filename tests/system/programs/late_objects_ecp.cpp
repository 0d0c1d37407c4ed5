// An ECP that makes robots and sensors while it runs.
#include "late_objects.hpp"
#include "mrroc/ecp.hpp"

using namespace mrroc;

namespace {

class Late : public ecp::Task {
  test::LateObjects objects_{*this, ""};

 public:
  Late() {
    on<test::Make>([this](const test::Make&) { objects_.use_sensor("clock"); });
  }

 private:
  void run() override { objects_.make(); }
};

}  // namespace

MRROC_ECP(Late)
