#pragma once

#include <string>

#include "edp/driver.hpp"
#include "edp/shell.hpp"

/// The conformance test of drivers: thirty-three checks that any driver's author can run on theirs
/// (`mrroc_add_driver_test`, docs/how-to/writing-a-driver.md).
namespace mrroc::driver_test {

/// What a device, or the way to it, does wrong.
enum class Trouble {
  silence,      ///< it answers nothing, and keeps its state
  loss,         ///< one answer in five is lost
  doubling,     ///< each answer comes twice
  lateness,     ///< each answer comes three ticks late
  garbage,      ///< each answer is followed by bytes without a meaning
  not_finite,   ///< it measures NaN
  jump,         ///< it measures 5 rad of the first shaft more from now on
  no_power,     ///< it refuses to be switched on
  drive_fault,  ///< one of its drives has a fault, until it is reset after the end of this trouble
  restart       ///< it restarts: without power, and without memory of what it was ordered
};

/// The device at the other end of a driver, made by the driver's author for the test. The test's thread makes every
/// call; what the device does by itself is its own threads' work.
class StandIn {
 public:
  virtual ~StandIn() = default;
  /// Keys of the driver's table in the deployment, as lines of TOML, such as the port where it listens.
  virtual std::string keys() const { return {}; }
  /// Begins to answer, at rest at `shafts` (rad), without power.
  virtual void start(const JointVector& shafts) = 0;
  /// Answers nothing from now on, and is ready for another `start`. Also called when it has not been started.
  virtual void stop() = 0;
  /// False: there is no way to have the driver without its device, as of a plant model.
  virtual bool can_be_absent() const { return true; }
  /// Comes before each tick of the driver: the device's time, where the test gives it.
  virtual void advance(Tick /*tick*/) {}
  /// Gets every reading of the driver, rad: the truth of a driver that is its own device, as a plant model.
  virtual void read(const JointVector& /*motors*/) {}
  /// True positions of the shafts, rad.
  virtual JointVector shafts() = 0;
  /// Whether it can make this trouble; a check that needs another one is counted as not made.
  virtual bool has(Trouble /*trouble*/) const { return false; }
  /// Begins or ends a trouble.
  virtual void set(Trouble /*trouble*/, bool /*on*/) {}
  /// The simulated world of a driver that declares one, with the robot in slot 0.
  virtual world::WorldMemory* world() { return nullptr; }
  /// s
  virtual double servo_period() const { return 0.002; }
  /// True: ticks follow each other as fast as the driver takes them. False: one in each servo period of the wall's
  /// time.
  virtual bool simulated_time() const { return false; }
};

/// main() of a conformance test: `NAME [--only NUMBER] DRIVER TYPE [PARAMETERS]`. Prints a line for each check and its
/// reason; exit code 0 unless one has failed.
int run(int argc, char** argv, StandIn& stand_in, const edp::ModelFactory& load_models);

}  // namespace mrroc::driver_test

/// Makes a conformance test of a class derived from StandIn, with a default constructor, and the function that loads
/// the robot's models.
#define MRROC_DRIVER_TEST(stand_in_class, load_models)                 \
  int main(int argc, char** argv) {                                    \
    stand_in_class stand_in;                                           \
    return mrroc::driver_test::run(argc, argv, stand_in, load_models); \
  }
