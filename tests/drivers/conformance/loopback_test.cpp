#include "mrroc/testing/driver.hpp"
#include "robots/irb6/irb6_model.hpp"

namespace mrroc::driver_test {
namespace {

/// The plant model is its own device.
class Loopback final : public StandIn {
 public:
  void start(const JointVector& shafts) override { shafts_ = shafts; }
  void stop() override {}
  bool can_be_absent() const override { return false; }
  void read(const JointVector& motors) override { shafts_ = motors; }
  JointVector shafts() override { return shafts_; }
  bool simulated_time() const override { return true; }

 private:
  JointVector shafts_;
};

}  // namespace
}  // namespace mrroc::driver_test

MRROC_DRIVER_TEST(mrroc::driver_test::Loopback, mrroc::load_irb6)
