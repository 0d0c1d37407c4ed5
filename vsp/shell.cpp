#include "vsp/shell.hpp"

#include <optional>

#include "links/exchange/sensor_responder.hpp"
#include "links/telemetry/state_follower.hpp"
#include "links/telemetry/telemetry_publisher.hpp"
#include "mrroc/stopped.hpp"
#include "process/picture_memory.hpp"
#include "process/process.hpp"
#include "process/standard_files.hpp"
#include "vsp/make_source.hpp"
#include "vsp/sampler.hpp"
#include "world/mapped_world.hpp"

namespace mrroc::vsp {

namespace {

std::size_t slot_of(const process::Process& process) {
  const auto& sensors = process.deployment().sensors;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (sensors[i].name == process.name()) return i;
  }
  throw SystemError(ErrorCode::configuration, "the deployment has no sensor for the process " + process.name());
}

/// Every process with a task may use the sensor; only processes that use it connect.
std::vector<std::string> possible_clients(const config::Deployment& deployment) {
  std::vector<std::string> names{"mp"};
  for (const config::RobotEntry& robot : deployment.robots) names.push_back(robot.name);
  return names;
}

class Shell : private ReadingSink {
 public:
  Shell(process::Process& process, const SensorFactory& factory)
      : process_(process),
        slot_(slot_of(process)),
        entry_(process.deployment().sensors[slot_]),
        sensor_(factory()),
        source_(open_source()),
        sampler_(*sensor_, *source_, publication_period(entry_, process.clock().period()), follows()),
        responder_(process.domain(), process.clock(), process.topic(entry_.name),
                   possible_clients(process.deployment()), !entry_.interactive),
        telemetry_(process.domain(), process.topic(entry_.name + "/telemetry")) {
    process.status().also([this] { telemetry_.publish(); });
  }
  ~Shell() override { process_.status().also({}); }
  Shell(const Shell&) = delete;
  Shell& operator=(const Shell&) = delete;

  void serve() {
    sampler_.watch(RawWatch(entry_, sensor_->raw_channels(), process_.clock().period()));
    if (follows()) {
      effector_.emplace(process_.domain(), process_.clock(), process_.topic(entry_.robot), entry_.name,
                        process_.deployment().robot(entry_.robot).edp_process());
      effector_->connect(process_.deployment().start_timeout);
    }
    process_.start();
    clock::Clock& clock = process_.clock();
    for (;;) {
      if (clock.wait(sampler_.next_wake()) == clock::Wake::interrupted) throw Stopped{};
      take_effector_states();
      take_requests();
      sampler_.on_tick(clock.tick(), *this);
    }
  }

 private:
  std::unique_ptr<Source> open_source() {
    const double period = process_.clock().period();
    sensor_->set_up(entry_, period);
    if (process_.arguments().world_fd >= 0) world_.emplace(world::MappedWorld::attach(process_.arguments().world_fd));
    if (const int fd = process_.arguments().picture_fd; fd >= 0)
      pictures_.emplace(process::PictureMemory::attach(fd, entry_.picture_width(), entry_.picture_height()));
    return make_source(*sensor_,
                       {process_.deployment(), entry_, slot_, world_ ? &**world_ : nullptr, period, &process_.clock(),
                        &process_.domain(), process_.faults().of(process_.name(), process_.clock()),
                        pictures_ ? &*pictures_ : nullptr});
  }

  /// Whether this sensor receives e_l.
  bool follows() const noexcept { return entry_.wants_effector_state && !entry_.robot.empty(); }

  void take_effector_states() {
    if (!effector_) return;
    while (effector_->take(state_)) sampler_.on_effector_state(state_);
  }

  void take_requests() {
    SensorRequest request;
    Caller caller;
    while (responder_.take(request, caller)) sampler_.on_request(caller, request, process_.clock().tick(), *this);
  }

  void reply(const Caller& caller, const SensorReading& reading) override {
    responder_.reply(reading, caller);
    if (telemetry_.wanted()) telemetry_.store(reading);
  }
  void publish(const SensorReading& reading) override {
    responder_.publish(reading);
    if (telemetry_.wanted()) telemetry_.store(reading);
  }

  process::Process& process_;
  std::size_t slot_;
  const config::SensorEntry& entry_;
  std::unique_ptr<VirtualSensor> sensor_;
  std::optional<world::MappedWorld> world_;
  std::optional<process::PictureMemory> pictures_;
  std::unique_ptr<Source> source_;
  Sampler sampler_;
  links::SensorResponder responder_;
  links::TelemetryPublisher<SensorReading> telemetry_;
  std::optional<links::StateFollower> effector_;
  RobotState state_;
};

}  // namespace

int run(int argc, char** argv, const SensorFactory& factory) {
  process::open_standard_files();
  return process::run_process(argc, argv, links::ProcessRole::vsp,
                              [&factory](process::Process& process) { Shell(process, factory).serve(); });
}

}  // namespace mrroc::vsp
