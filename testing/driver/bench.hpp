#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "config/deployment.hpp"
#include "edp/check/model_set.hpp"
#include "edp/command/effector.hpp"
#include "edp/servo/robot_ticker.hpp"
#include "edp/servo/servo.hpp"
#include "mrroc/testing/driver.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "testing/driver/counts.hpp"

namespace mrroc::driver_test {

/// A check has found a fault of the driver; `what()` says which.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A check cannot be made with this stand-in; `what()` says what it lacks.
struct NotMade : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws Failure unless `holds`.
void expect(bool holds, const std::string& otherwise);

/// The greatest difference of two vectors.
inline double farthest(const JointVector& a, const JointVector& b) { return (a - b).cwiseAbs().maxCoeff(); }

/// What all checks of a run share.
struct Subject {
  std::string driver, type;
  std::filesystem::path parameters;  ///< empty: the type's own
  StandIn& stand_in;
  RobotModels models;
};

/// One driver with its device, for one check: made for it, and taken down after it. Ticks are counted from 0.
class Bench {
 public:
  explicit Bench(const Subject& subject) : subject_(subject) {}
  ~Bench();
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  double period() const { return subject_.stand_in.servo_period(); }
  StandIn& device() { return subject_.stand_in; }
  const RobotModel& model() const { return *subject_.models.front(); }
  int axes() const { return model().joint_count(); }
  JointVector home() const;  ///< of the shafts, rad
  /// The robot's entry in a deployment with the driver's keys; `more` are further lines of its table. Throws
  /// ConfigurationError.
  config::Deployment deployment(const std::string& more = {});
  /// Throws NotMade unless the device can make this trouble.
  void need(Trouble trouble) const;

  /// Makes the driver, without its device.
  void make();
  /// Starts the device at home, makes the driver, opens it.
  void open();
  /// Opens the driver that `make` has made.
  void connect();
  void close();
  edp::Hardware& hardware() { return *hardware_; }

  /// One tick without a servo: reads, gives the set-point `target`, writes currents of zero.
  const edp::HardwareInput& tick();
  const edp::HardwareInput& ticks(int count);
  /// One tick at the next package of a driver with a clock of its own; false: none came in 100 of its periods.
  bool beat(edp::Beat& beat);
  JointVector target;  ///< of the shafts, rad
  const edp::HardwareInput& input() const { return input_; }
  /// Runs ticks until `holds` for the reading, at most `most`; false if it never did.
  bool until(const std::function<bool(const edp::HardwareInput&)>& holds, int most);

  /// From now on the servo ticks the driver: switches the drives on, and waits until they are.
  void power();
  void servo_ticks(int count);
  /// One of them; what its driver and servo have done, without the device and the pace.
  Counts count_servo_tick();
  bool servo_until(const std::function<bool(const edp::Snapshot&)>& holds, int most);
  const edp::Snapshot& seen() const { return servo_->snapshot(); }
  bool drives_on() const { return servo_->drives_on(); }
  /// A motion of every axis by this part of a tenth of its range, in 200 ticks; false if it was refused or broken off.
  bool move(double part);
  /// Why a motion or a recovery has failed.
  std::string reason() const;
  /// Starts it only.
  void start_move(double part);
  /// Clears faults and switches the drives on again; false if that did not succeed in 5000 ticks.
  bool recover();
  JointVector way(double part) const;  ///< rad or m of each joint

  /// After each servo tick and each tick.
  std::function<void()> after_tick;
  Tick now() const { return now_; }

 private:
  edp::RobotTicker::Place next();
  void exchange(edp::RobotTicker::Place place);
  void pace() const;
  bool answered(std::uint64_t number);

  const Subject& subject_;
  task_test::ScratchFolder scratch_;
  config::Deployment deployment_;
  std::unique_ptr<edp::Hardware> hardware_;
  edp::HardwareInput input_;
  Tick now_ = 0;                            ///< after the last tick
  std::optional<edp::RobotTicker> ticker_;  ///< of a robot that keeps the time
  edp::ServoChannel channel_;
  std::optional<edp::ModelSet> models_;
  std::unique_ptr<edp::Servo> servo_;
  std::unique_ptr<edp::Effector> effector_;
  std::uint64_t number_ = 0;
  edp::Reply reply_;
};

}  // namespace mrroc::driver_test
