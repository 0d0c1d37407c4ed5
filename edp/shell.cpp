#include "edp/shell.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

#include "clock/leave.hpp"
#include "config/robot_place.hpp"
#include "edp/check/robot_check.hpp"
#include "edp/command/effector.hpp"
#include "edp/command/operator_motion.hpp"
#include "edp/command/order_kind.hpp"
#include "edp/describe.hpp"
#include "edp/drivers/injected_hardware.hpp"
#include "edp/drivers/load_driver.hpp"
#include "edp/force/wrist_sensor.hpp"
#include "edp/robot_status.hpp"
#include "edp/servo/servo.hpp"
#include "edp/servo/servo_thread.hpp"
#include "kinematics/loaded_model.hpp"
#include "kinematics/measured_model.hpp"
#include "links/exchange/robot_responder.hpp"
#include "links/telemetry/state_feed.hpp"
#include "links/telemetry/telemetry_publisher.hpp"
#include "mrroc/stopped.hpp"
#include "process/process.hpp"
#include "process/standard_files.hpp"
#include "world/mapped_world.hpp"

namespace mrroc::edp {

namespace {

constexpr double kTelemetryPeriod = 0.02;  // s between two states for watchers
constexpr double kSilentPowerUp = 1;       // s, then the wait is reported

class Shell {
 public:
  Shell(process::Process& process, const ModelFactory& factory)
      : process_(process),
        place_(config::robot_of_process(process.deployment(), process.name())),
        machine_models_(load_models(factory)),
        models_(kinematics::with_measured(machine_models_, place_.entry.measured_arm)),
        model_set_(models_),
        hardware_(open_hardware()),
        force_sensor_(open_force_sensor()),
        servo_(model_set_, *hardware_, process.clock().period(), channel_),
        effector_(model_set_, process.clock().period(), channel_),
        operator_motion_(effector_, model_set_, process.clock().period()),
        status_(process.status(), models_.front()->parameters()),
        responder_(process.domain(), process.clock(), process.topic(place_.entry.name),
                   process.deployment().heartbeat_timeout),
        operator_(process.domain(), process.clock(), process.topic(place_.entry.name + "/operator"),
                  std::numeric_limits<double>::infinity()),
        telemetry_(process.domain(), process.topic(place_.entry.name + "/telemetry")),
        telemetry_period_(static_cast<Tick>(std::ceil(kTelemetryPeriod / process.clock().period()))) {
    for (const config::SensorEntry& sensor : process.deployment().sensors)
      if (sensor.robot == place_.entry.name && sensor.wants_effector_state)
        feeds_.emplace_back(process.domain(), process.clock(), process.topic(place_.entry.name), sensor.name);
    servo_.use_emergency_stop(process.clock().emergency_stop());
    servo_.use_group_stops(process.clock().group_stops(), place_.index);
    if (place_.entry.emergency_stop) servo_.use_emergency_terminal(*place_.entry.emergency_stop);
    if (const int fd = process.arguments().record_fd; fd >= 0)
      servo_.use_tap(tap_.emplace(ServoTap::attach(fd, kServoTapWhat)), process.clock().simulated());
    if (force_sensor_ != nullptr) {
      servo_.use_force_sensor(*force_sensor_, place_.entry.force_limits);
      effector_.use_force_sensor(force_sensor_->mount());
    }
    process.status().also([this] { telemetry_.publish(); });  // last: another thread calls it
  }

  ~Shell() {
    process_.status().also({});
    if (tap_) tap_->end();
  }
  Shell(const Shell&) = delete;
  Shell& operator=(const Shell&) = delete;

  void serve() {
    process_.start();
    effector_.enable(true);
    if (process_.clock().simulated()) {
      serve_simulated();
    } else {
      serve_real();
    }
    // they send their last frames while simulated peers take part; the links' end takes seconds on a busy machine
    hardware_.reset();
    force_sensor_.reset();
    clock::leave(process_.clock());
    throw Stopped{};
  }

 private:
  world::WorldMemory& world() {
    if (!world_) world_.emplace(world::MappedWorld::attach(process_.arguments().world_fd));
    return **world_;
  }

  std::unique_ptr<ForceSensor> open_force_sensor() {
    const auto& sensors = process_.deployment().sensors;
    for (std::size_t i = 0; i < sensors.size(); ++i) {
      if (sensors[i].name != place_.entry.force_sensor) continue;
      const world::WorldMemory* const simulated = sensors[i].source == "simulated" ? &world() : nullptr;
      return std::make_unique<WristSensor>(
          load_wrench_source(sensors[i]),
          vsp::SourceContext{process_.deployment(), sensors[i], i, simulated, process_.clock().period(),
                             &process_.clock(), nullptr, process_.faults().of(sensors[i].name, process_.clock())});
    }
    return nullptr;
  }

  RobotModels load_models(const ModelFactory& factory) const {
    RobotModels models = factory(place_.entry.own_edp() ? place_.entry.parameters : place_.entry.files().parameters);
    check_robot(models, place_.entry.type, place_.entry.files());
    return kinematics::with_load(std::move(models), place_.entry.load);
  }

  std::unique_ptr<Hardware> open_hardware() {
    const config::RobotEntry& robot = place_.entry;
    std::unique_ptr<Hardware> hardware =
        load_driver({robot, *machine_models_.front(), process_.clock().period(), process_.clock().simulated(),
                     robot.driver.world ? &world() : nullptr, place_.index});
    if (auto faults = process_.faults().of(process_.name(), process_.clock()); !faults.empty())
      hardware =
          std::make_unique<InjectedHardware>(std::move(hardware), std::move(faults), models_.front()->parameters());
    hardware->open();
    return hardware;
  }

  void serve_simulated() {
    clock::Clock& clock = process_.clock();
    servo_.tick(0);  // so that a command of tick 0 finds the robot's state
    feed();
    Tick next = 1;
    bool ready = false;
    for (;;) {
      const clock::Wake wake = clock.wait(next);
      if (wake == clock::Wake::interrupted) return;
      if (clock.tick() >= next) {
        if (clock.stopping()) servo_.leave();
        servo_.tick(clock.tick());
        next = clock.tick() + 1;
        feed();
      }
      ready = ready || switched_on();
      if (ready)
        exchange();
      else
        await_drives();
      store_telemetry();
      status_.report(effector_, servo_);
      if (clock.stopping() && !servo_.drives_on()) return;
    }
  }

  void serve_real() {
    clock::Clock& clock = process_.clock();
    ServoThread thread(servo_, clock, feeds_.empty() ? telemetry_period_ : 1);
    bool runs = !clock.stopping();
    for (; runs && !switched_on();
         runs = clock.wait(clock.tick() + 1) != clock::Wake::interrupted && !clock.stopping()) {
      feed();
      await_drives();
      store_telemetry();
      status_.report(effector_, servo_, &thread.statistics());
    }
    for (; runs; runs = clock.wait(kNever) != clock::Wake::interrupted && !clock.stopping()) {
      feed();
      exchange();
      store_telemetry();
      status_.report(effector_, servo_, &thread.statistics());
    }
    // the thread's destructor stops the robot and switches the drives off
  }

  /// Before the drives are on the task's first command waits, and orders of the operator are refused.
  void await_drives() {
    waits_ = responder_.take(command_, sequence_) || waits_;
    std::uint64_t sequence = 0;
    while (operator_.take(order_, sequence)) refuse("the drives are being switched on", sequence);
    say_that_drives_are_switched_on();
  }

  void refuse(const char* reason, std::uint64_t order) {
    reply_.state = RobotState{};
    effector_.peek(reply_.state);
    reply_.state.error = make_report(ErrorClass::non_fatal, ErrorCode::busy, "%s", reason);
    operator_.reply(reply_.state, order);
  }

  /// It may take a robot with a controller of its own some ten seconds.
  void say_that_drives_are_switched_on() {
    if (said_ || static_cast<double>(process_.clock().tick()) * process_.clock().period() < kSilentPowerUp) return;
    said_ = true;
    std::puts("the drives are being switched on");
    std::fflush(stdout);
  }

  /// The drives are on, or a fault keeps them off: from now on every command gets its answer.
  bool switched_on() noexcept {
    const Snapshot* snapshot = effector_.snapshot();
    return snapshot != nullptr && (snapshot->enabled() || snapshot->fault.code != ErrorCode::none);
  }

  /// The state e_l of the newest tick, to the sensors that use it.
  void feed() {
    if (feeds_.empty() || !effector_.peek(fed_)) return;
    for (links::StateFeed& each : feeds_) each.send(fed_);
  }

  /// The state of the newest tick, for watchers.
  void store_telemetry() {
    const Tick now = process_.clock().tick();
    if (now < next_telemetry_ || !telemetry_.wanted() || !effector_.peek(fed_)) return;
    next_telemetry_ = now + telemetry_period_;
    telemetry_.store(fed_);
  }

  /// Sends due replies, then takes received commands.
  void exchange() {
    if (std::exchange(waits_, false)) accept(sequence_);
    while (effector_.poll(reply_)) {
      if (!OperatorMotion::is_own(reply_.command))
        responder_.reply(reply_.state, reply_.command);
      else if (operator_motion_.take(reply_))
        operator_.reply(reply_.state, reply_.command);
    }
    std::uint64_t sequence = 0;
    while (responder_.take(command_, sequence)) accept(sequence);
    if (operator_motion_.update(process_.clock().tick(), reply_)) operator_.reply(reply_.state, reply_.command);
    if (operator_motion_.hold_for_late_motion(reply_)) responder_.reply(reply_.state, reply_.command);
    if (operator_motion_.poll_hold(process_.clock().tick(), reply_)) responder_.reply(reply_.state, reply_.command);
    while (operator_.take(command_, sequence)) {
      // a robot must not move by an order of the past; it may come to rest by one
      if (command_.kind != CommandKind::hold && !operator_.fresh(OperatorMotion::kJogValidity)) {
        if (!is_jog(command_)) refuse("the order has come too late", sequence);
        continue;
      }
      if (operator_motion_.accept(command_, sequence, process_.clock().tick(), reply_))
        operator_.reply(reply_.state, reply_.command);
    }
  }

  /// Takes `command_`, number `sequence` of the task.
  void accept(std::uint64_t sequence) {
    if (operator_motion_.accept_of_task(command_, sequence, process_.clock().tick())) return;
    if (effector_.accept(command_, sequence, reply_)) responder_.reply(reply_.state, sequence);
  }

  process::Process& process_;
  config::RobotPlace place_;
  /// As the type describes them: what drivers turn the readings of controllers into shafts by.
  RobotModels machine_models_;
  RobotModels models_;  ///< as measured
  ModelSet model_set_;
  std::optional<world::MappedWorld> world_;
  std::unique_ptr<Hardware> hardware_;         ///< null at the end
  std::unique_ptr<ForceSensor> force_sensor_;  ///< null: no force sensor, or the end
  ServoChannel channel_;
  std::optional<ServoTap> tap_;  ///< the run is recorded at the rate of servo ticks
  Servo servo_;
  Effector effector_;
  OperatorMotion operator_motion_;
  RobotStatus status_;
  links::RobotResponder responder_;
  links::RobotResponder operator_;  ///< of orders without a task
  links::TelemetryPublisher<RobotState> telemetry_;
  const Tick telemetry_period_;
  Tick next_telemetry_ = 0;
  std::deque<links::StateFeed> feeds_;
  RobotState fed_;
  RobotCommand command_, order_;
  bool waits_ = false;  ///< `command_`, the task's first one, number `sequence_`, for the drives to be on
  std::uint64_t sequence_ = 0;
  bool said_ = false;
  Reply reply_;
};

}  // namespace

int run(int argc, char** argv, const ModelFactory& factory) {
  process::open_standard_files();
  if (argc > 1 && describes(argv[1])) return describe(argc, argv, factory);
  return process::run_process(argc, argv, links::ProcessRole::edp, [&factory](process::Process& process) {
    // on the heap: the hand-over's queues are larger than a stack should be
    std::make_unique<Shell>(process, factory)->serve();
  });
}

}  // namespace mrroc::edp
