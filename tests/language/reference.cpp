// The reference model of Move and Wait, written from the paper's equations (3) and (5), not from the language's code:
// it has its own robots, sensors and time, and records the calls that must be made.
#include "language/script.hpp"

namespace mrroc::fakes {

bool predict_value(const Script& script, std::size_t node, std::uint64_t k) {
  const NodeScript& it = script.nodes[node];
  switch (it.kind) {
    case NodeScript::Kind::leaf:
      return script.leaves[it.a].at(k);
    case NodeScript::Kind::both:
      return predict_value(script, it.a, k) && predict_value(script, it.b, k);
    case NodeScript::Kind::either:
      return predict_value(script, it.a, k) || predict_value(script, it.b, k);
    case NodeScript::Kind::negated:
      return !predict_value(script, it.a, k);
  }
  return false;
}

std::string predict_name(const Script& script, std::size_t node) {
  const NodeScript& it = script.nodes[node];
  if (it.kind == NodeScript::Kind::leaf) return "leaf" + std::to_string(it.a);
  if (it.named) return "node" + std::to_string(node);
  if (it.kind == NodeScript::Kind::negated) return "not (" + predict_name(script, it.a) + ")";
  const char* const word = it.kind == NodeScript::Kind::both ? " and " : " or ";
  return predict_name(script, it.a) + word + predict_name(script, it.b);
}

void predict_reasons(const Script& script, std::size_t node, std::uint64_t k, Result& result) {
  const NodeScript& it = script.nodes[node];
  const bool combination = it.kind == NodeScript::Kind::both || it.kind == NodeScript::Kind::either;
  if (!combination || it.named) result.reasons.push_back(predict_name(script, node));
  if (it.kind == NodeScript::Kind::leaf) (script.leaves[it.a].red ? result.by_red : result.by_blue) = true;
  if (!combination) return;
  if (predict_value(script, it.a, k)) predict_reasons(script, it.a, k, result);
  if (predict_value(script, it.b, k)) predict_reasons(script, it.b, k, result);
}

namespace {

struct ModelRobot {
  Tick tick = 0;
  Tick desired_tick = 0;
  bool moving = false;
  std::uint64_t replies = 0;
  const FaultScript* fault = nullptr;
};

struct ModelSensor {
  Tick tick = 0;
  double value = 0;
  std::uint64_t readings = 0;
  Tick requested_at = 0;
  bool not_ready = false;
  const FaultScript* fault = nullptr;
};

class Model {
 public:
  explicit Model(const Script& script)
      : script_(script), robots_(script.robots.size()), sensors_(script.sensors.size()) {
    for (ModelRobot& robot : robots_) robot.tick = robot.desired_tick = now_;
  }

  RunRecord run() {
    const Tick begin_now = now_;
    get();
    const Tick begin = newest();
    if (error()) return finish_with_error();
    start_leaves(root());
    if (script_.is_move) call(Action::start_generator);
    for (;; ++step_) {
      OperatorRequest request = next_request();
      if (request == OperatorRequest::pause) {
        do {
          exchange(true, 0);
          if (error()) return finish_with_error();
          request = next_request();
        } while (request == OperatorRequest::pause);
        if (request == OperatorRequest::none && script_.is_move) call(Action::resume_generator);
      }
      if (request == OperatorRequest::stop) {
        observe(true);
        run_.stopped = true;
        return run_;
      }
      if (request == OperatorRequest::end_motion) return finish(Ending::end_motion, begin, begin_now);
      evaluate_leaves(root());
      if (script_.is_move) call(Action::terminal_condition);
      if (!script_.nodes.empty() && predict_value(script_, root(), step_)) {
        return finish(Ending::condition, begin, begin_now);
      }
      if (script_.is_move && step_ >= script_.generator_ends) return finish(Ending::generator, begin, begin_now);
      if (script_.is_move) call(Action::next_state);
      exchange(false, step_ + 1);
      if (error()) {
        ++step_;
        return finish_with_error();
      }
    }
  }

 private:
  std::size_t root() const { return script_.nodes.size() - 1; }
  std::string robot_name(std::size_t i) const { return "robot" + std::to_string(i); }
  std::string sensor_name(std::size_t i) const { return "sensor" + std::to_string(i); }
  void call(Action action, const std::string& device = "", Tick tick = 0) {
    Call it;
    it.action = action;
    it.device = device;
    it.tick = tick;
    run_.calls.push_back(it);
  }

  OperatorRequest next_request() {
    call(Action::ask_operator);
    return asked_ < script_.requests.size() ? script_.requests[asked_++] : OperatorRequest::none;
  }

  void start_leaves(std::size_t node) { visit_leaves(node, Action::start_condition); }
  void evaluate_leaves(std::size_t node) { visit_leaves(node, Action::evaluate); }
  void visit_leaves(std::size_t node, Action action) {
    if (script_.nodes.empty()) return;
    const NodeScript& it = script_.nodes[node];
    if (it.kind == NodeScript::Kind::leaf) return call(action, predict_name(script_, node));
    visit_leaves(it.a, action);
    if (it.kind != NodeScript::Kind::negated) visit_leaves(it.b, action);
  }

  void send(std::size_t i, CommandKind kind, Tick start, double value) {
    Call it;
    it.action = Action::send;
    it.device = robot_name(i);
    it.tick = start;
    it.kind = kind;
    it.motion_steps = script_.robots[i].motion_steps;
    it.reply_step = script_.robots[i].reply_step;
    it.value = value;
    run_.calls.push_back(it);
  }

  void receive(std::size_t i) {
    call(Action::receive, robot_name(i));
    robots_[i].fault = find_fault(true, i, robots_[i].replies++);
  }

  const FaultScript* find_fault(bool of_robot, std::size_t device, std::uint64_t reception) const {
    for (const FaultScript& fault : script_.faults) {
      if (fault.of_robot == of_robot && fault.device == device && fault.reception == reception) return &fault;
    }
    return nullptr;
  }

  void collect(std::size_t i) {
    const SensorScript& it = script_.sensors[i];
    ModelSensor& sensor = sensors_[i];
    call(it.interactive ? Action::collect : Action::latest, sensor_name(i));
    const std::uint64_t number = sensor.readings++;
    sensor.not_ready = !it.interactive && number < it.ready_from;
    if (sensor.not_ready) return;
    sensor.fault = find_fault(false, i, number);
    sensor.tick = it.interactive ? sensor.requested_at : now_;
    sensor.value = 100.0 * static_cast<double>(i) + static_cast<double>(number);
    now_ = std::max(now_, sensor.tick);
  }

  void get() {
    for (std::size_t i = 0; i < sensors_.size(); ++i) {
      sensors_[i].requested_at = now_;
      if (script_.sensors[i].interactive) call(Action::request, sensor_name(i));
    }
    for (std::size_t i = 0; i < robots_.size(); ++i) send(i, CommandKind::query, 0, 0);
    for (std::size_t i = 0; i < robots_.size(); ++i) receive(i);
    for (std::size_t i = 0; i < sensors_.size(); ++i) collect(i);
  }

  /// Several robots begin on one tick: the earliest possible one of the last robot. From rest that is not before the
  /// commands have had 2 ticks. A robot at rest does not delay moving ones.
  Tick common_start() const {
    if (robots_.size() < 2) return 0;
    const bool moving = std::any_of(robots_.begin(), robots_.end(), [](const ModelRobot& r) { return r.moving; });
    Tick start = moving ? 0 : now_ + 2;
    for (const ModelRobot& robot : robots_) {
      if (!moving || robot.moving) start = std::max(start, robot.desired_tick);
    }
    return start;
  }

  /// One macrostep of all robots, and the readings that are due at its end.
  void exchange(bool pause, std::uint64_t next_step) {
    const Tick start = pause ? 0 : common_start();
    std::vector<Tick> begins;
    Tick measured_at = robots_.empty() ? now_ + 10 : 0;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      begins.push_back(std::max({start, robots_[i].desired_tick, now_}));
      measured_at = std::max(measured_at, begins[i] + static_cast<Tick>(script_.robots[i].reply_step));
    }
    const auto due = [&](std::size_t i) { return next_step % script_.sensors[i].period == 0; };
    for (std::size_t i = 0; i < sensors_.size(); ++i) {
      if (due(i)) sensors_[i].requested_at = measured_at;
      if (due(i) && script_.sensors[i].interactive) call(Action::request, sensor_name(i), measured_at);
    }
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const bool commanded = script_.is_move && !pause && script_.robots[i].addressed;
      const double value = (sensors_.empty() ? 0.0 : sensors_[0].value) + static_cast<double>(i);
      send(i, commanded ? CommandKind::joint : CommandKind::hold, start, commanded ? value : 0.0);
    }
    if (!pause) observe(false);
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      receive(i);
      const bool commanded = script_.is_move && !pause && script_.robots[i].addressed;
      ModelRobot& robot = robots_[i];
      robot.tick = begins[i] + static_cast<Tick>(script_.robots[i].reply_step);
      robot.desired_tick = std::max(begins[i] + static_cast<Tick>(script_.robots[i].motion_steps), robot.tick);
      robot.moving = commanded && script_.robots[i].moving;
    }
    if (robots_.empty()) call(Action::sleep, "", measured_at);
    now_ = std::max(now_, measured_at);
    for (std::size_t i = 0; i < sensors_.size(); ++i) {
      if (due(i)) collect(i);
    }
  }

  /// f_E at this step: the most severe error reported, the first in the lists among equals.
  bool error() {
    const auto check = [&](ErrorClass error_class, ErrorCode code, const std::string& device, Tick tick) {
      if (run_.error && run_.error->error_class >= error_class) return;
      run_.error = ThrownError{error_class, code, "test", device, 0, tick};
    };
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const FaultScript* fault = robots_[i].fault;
      if (fault != nullptr) check(fault->error_class, fault->code, robot_name(i), robots_[i].tick);
    }
    for (std::size_t i = 0; i < sensors_.size(); ++i) {
      const ModelSensor& sensor = sensors_[i];
      if (sensor.not_ready)
        check(ErrorClass::non_fatal, ErrorCode::sensor_not_ready, sensor_name(i), sensor.tick);
      else if (sensor.fault != nullptr)
        check(sensor.fault->error_class, sensor.fault->code, sensor_name(i), sensor.tick);
    }
    return run_.error.has_value();
  }

  Tick newest() const {
    Tick tick = 0;
    for (const ModelRobot& robot : robots_) tick = std::max(tick, robot.tick);
    for (const ModelSensor& sensor : sensors_) tick = std::max(tick, sensor.tick);
    return tick;
  }

  void observe(bool last) {
    call(Action::observe, last ? "last" : "", newest());
    run_.calls.back().value = static_cast<double>(step_);
  }

  RunRecord finish_with_error() {
    run_.error->step = step_;
    if (run_.error->tick == 0) run_.error->tick = newest();
    observe(true);
    if (run_.error->error_class != ErrorClass::system) rest();
    return run_;
  }

  /// Moving robots hold; a fake rests at once.
  void rest() {
    for (std::size_t i = 0; i < robots_.size(); ++i)
      if (robots_[i].moving) send(i, CommandKind::hold, 0, 0);
    for (std::size_t i = 0; i < robots_.size(); ++i)
      if (robots_[i].moving) receive(i);
  }

  RunRecord finish(Ending ending, Tick begin, Tick begin_now) {
    observe(true);
    Result result{ending, step_, begin, newest(), 0, 0, {}, false, false};
    result.duration = static_cast<double>(result.end_tick - begin) * 0.002;
    result.wall_duration = 2 * static_cast<double>(now_) * 0.002 - 2 * static_cast<double>(begin_now) * 0.002;
    if (ending == Ending::condition) predict_reasons(script_, root(), step_, result);
    run_.result = result;
    return run_;
  }

  const Script& script_;
  std::vector<ModelRobot> robots_;
  std::vector<ModelSensor> sensors_;
  Tick now_ = 1000;
  std::uint64_t step_ = 0;
  std::size_t asked_ = 0;
  RunRecord run_;
};

}  // namespace

RunRecord predict(const Script& script) { return Model(script).run(); }

}  // namespace mrroc::fakes
