#include "language/script.hpp"

#include "language/fakes.hpp"
#include "mrroc/move.hpp"
#include "mrroc/stopped.hpp"

namespace mrroc::fakes {

class Leaf : public Condition {
 public:
  Leaf(std::string name, LeafScript script, CallLog* log) : Condition(std::move(name)), script_(script), log_(log) {}
  void start() override {
    if (log_ != nullptr) log_->add({Action::start_condition, name()});
    evaluated_ = 0;
  }

 protected:
  bool holds() override {
    if (log_ != nullptr) log_->add({Action::evaluate, name()});
    return script_.at(evaluated_++);
  }

 private:
  LeafScript script_;
  CallLog* log_;
  std::uint64_t evaluated_ = 0;
};

class Red : public Leaf {
  using Leaf::Leaf;
};
class Blue : public Leaf {
  using Leaf::Leaf;
};

namespace {

/// Commands the addressed robots to the first sensor's value (or 0) plus their number.
class ScriptedGenerator : public Generator {
 public:
  ScriptedGenerator(const Script& script, const std::vector<Robot*>& robots, const std::vector<Sensor*>& sensors,
                    CallLog& log)
      : Generator("scripted"), script_(script), robots_(robots), sensors_(sensors), log_(log) {}

  void start() override { log_.add({Action::start_generator, ""}); }
  void resume() override { log_.add({Action::resume_generator, ""}); }
  /// What robots do on a common way that a generator can stretch is the law of common_stop_test.cpp.
  bool scales_with_speed() const override { return robots_.size() < 2; }
  bool terminal_condition() override {
    log_.add({Action::terminal_condition, ""});
    return evaluated_++ >= script_.generator_ends;
  }
  void next_state() override {
    log_.add({Action::next_state, ""});
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      if (!script_.robots[i].addressed) continue;
      RobotCommand& command = robots_[i]->command();
      command.kind = CommandKind::joint;
      const double value = (sensors_.empty() ? 0.0 : sensors_[0]->value(0)) + static_cast<double>(i);
      command.joints = JointVector::Constant(2, value);
      if (script_.robots[i].moving) command.joint_velocity = JointVector::Constant(2, 0.1);
    }
  }

 private:
  const Script& script_;
  const std::vector<Robot*>& robots_;
  const std::vector<Sensor*>& sensors_;
  CallLog& log_;
  std::uint64_t evaluated_ = 0;
};

class Observer : public StepObserver {
 public:
  explicit Observer(CallLog& log) : log_(log) {}
  void on_step(const StepRecord& record) noexcept override {
    log_.add({.action = Action::observe,
              .device = record.last() ? "last" : "",
              .tick = record.tick,
              .value = static_cast<double>(record.step)});
  }

 private:
  CallLog& log_;
};

void attach(Generator& generator, const Script& script, CallLog& log) {
  if (script.nodes.empty()) return;
  const NodeScript& root = script.nodes.back();
  const auto part = [&](std::size_t node) { return build_condition(script, node, &log); };
  const auto until = [&](auto condition) {
    if (root.named) condition.rename(predict_name(script, script.nodes.size() - 1));
    generator.until(std::move(condition));
  };
  switch (root.kind) {
    case NodeScript::Kind::leaf: {
      const auto leaf = part(script.nodes.size() - 1);
      if (auto* red = dynamic_cast<Red*>(leaf.get())) generator.until(*red);
      if (auto* blue = dynamic_cast<Blue*>(leaf.get())) generator.until(*blue);
      break;
    }
    case NodeScript::Kind::both:
      return until(Both{part(root.a), part(root.b)});
    case NodeScript::Kind::either:
      return until(Either{part(root.a), part(root.b)});
    case NodeScript::Kind::negated:
      return until(Negated{part(root.a)});
  }
}

void add_faults(FakeTask& task, const Script& script) {
  for (const FaultScript& fault : script.faults) {
    const ErrorReport report{fault.error_class, fault.code, {}};
    const std::string number = std::to_string(fault.device);
    auto& errors =
        fault.of_robot ? task.robot_fake("robot" + number).errors : task.sensor_fake("sensor" + number).errors;
    errors.emplace(fault.reception, report);
  }
}

}  // namespace

std::shared_ptr<Condition> build_condition(const Script& script, std::size_t node, CallLog* log) {
  const NodeScript& it = script.nodes[node];
  const auto part = [&](std::size_t n) { return build_condition(script, n, log); };
  std::shared_ptr<Condition> condition;
  switch (it.kind) {
    case NodeScript::Kind::leaf: {
      const std::string name = predict_name(script, node);
      const LeafScript& leaf = script.leaves[it.a];
      if (leaf.red) return std::make_shared<Red>(name, leaf, log);
      return std::make_shared<Blue>(name, leaf, log);
    }
    case NodeScript::Kind::both:
      condition = std::make_shared<Both>(part(it.a), part(it.b));
      break;
    case NodeScript::Kind::either:
      condition = std::make_shared<Either>(part(it.a), part(it.b));
      break;
    case NodeScript::Kind::negated:
      condition = std::make_shared<Negated>(part(it.a));
      break;
  }
  if (it.named) condition->rename(predict_name(script, node));
  return condition;
}

Result result_of(const Outcome& outcome) {
  Result result{outcome.ending,
                outcome.steps,
                outcome.start_tick,
                outcome.end_tick,
                outcome.duration,
                outcome.wall_duration,
                {},
                outcome.by<Red>(),
                outcome.by<Blue>()};
  for (const Condition* reason : outcome.reasons) result.reasons.push_back(reason->name());
  return result;
}

RunRecord execute(const Script& script) {
  FakeTask task;
  Observer observer(task.log);
  task.step_observer = &observer;
  task.requests = script.requests;
  std::vector<std::unique_ptr<Robot>> robots;
  std::vector<std::unique_ptr<Sensor>> sensors;
  std::vector<Robot*> robot_list;
  std::vector<Sensor*> sensor_list;
  for (const RobotScript& it : script.robots) {
    robots.push_back(task.robot("robot" + std::to_string(robots.size()), 2));
    robots.back()->set_macrostep(static_cast<std::uint16_t>(it.motion_steps),
                                 static_cast<std::uint16_t>(it.reply_step));
    robot_list.push_back(robots.back().get());
  }
  for (const SensorScript& it : script.sensors) {
    const std::string name = "sensor" + std::to_string(sensors.size());
    task.add_sensor(name, it.interactive, 100.0 * static_cast<double>(sensors.size())).ready_from = it.ready_from;
    sensors.push_back(task.sensor(name));
    sensors.back()->set_period(it.period);
    sensor_list.push_back(sensors.back().get());
  }
  add_faults(task, script);

  RunRecord run;
  try {
    if (script.is_move) {
      ScriptedGenerator generator(script, robot_list, sensor_list, task.log);
      attach(generator, script, task.log);
      run.result = result_of(Move(RobotList{robot_list}, SensorList{sensor_list}, generator));
    } else {
      run.result = result_of(Wait(RobotList{robot_list}, SensorList{sensor_list},
                                  build_condition(script, script.nodes.size() - 1, &task.log)));
    }
  } catch (const Error& error) {
    const ErrorOrigin& origin = error.origin();
    run.error = ThrownError{error.error_class(), error.code(), origin.process, origin.device, origin.step, origin.tick};
  } catch (const Stopped&) {
    run.stopped = true;
  }
  run.calls = std::move(task.log.calls);
  return run;
}

std::ostream& operator<<(std::ostream& out, const Script& script) {
  out << (script.is_move ? "Move" : "Wait") << "\n";
  for (const RobotScript& it : script.robots) {
    out << "  robot N" << it.motion_steps << " v" << it.reply_step << (it.addressed ? " addressed" : "")
        << (it.moving ? " moving" : "") << "\n";
  }
  for (const SensorScript& it : script.sensors) {
    out << "  sensor " << (it.interactive ? "interactive" : "non-interactive") << " period " << it.period << " ready "
        << it.ready_from << "\n";
  }
  for (const LeafScript& it : script.leaves) out << "  leaf " << std::hex << it.pattern << std::dec << "\n";
  if (!script.nodes.empty()) out << "  condition " << predict_name(script, script.nodes.size() - 1) << "\n";
  out << "  generator ends at " << script.generator_ends << "\n";
  for (const FaultScript& it : script.faults) {
    out << "  fault of " << (it.of_robot ? "robot" : "sensor") << it.device << " at reply " << it.reception
        << ", class " << static_cast<int>(it.error_class) << ", code " << static_cast<int>(it.code) << "\n";
  }
  out << "  operator";
  for (const OperatorRequest request : script.requests) out << " " << static_cast<int>(request);
  return out << "\n";
}

std::ostream& operator<<(std::ostream& out, const RunRecord& run) {
  for (const Call& call : run.calls) out << "  " << call << "\n";
  if (run.result) {
    const Result& it = *run.result;
    out << "  ending " << static_cast<int>(it.ending) << " steps " << it.steps << " ticks " << it.start_tick << ".."
        << it.end_tick << " duration " << it.duration << " wall " << it.wall_duration << " by";
    for (const std::string& reason : it.reasons) out << " '" << reason << "'";
    out << (it.by_red ? " red" : "") << (it.by_blue ? " blue" : "") << "\n";
  }
  if (run.error) {
    out << "  error class " << static_cast<int>(run.error->error_class) << " code " << static_cast<int>(run.error->code)
        << " " << run.error->process << " " << run.error->device << " step " << run.error->step << " tick "
        << run.error->tick << "\n";
  }
  return out << (run.stopped ? "  stopped\n" : "");
}

}  // namespace mrroc::fakes
