#pragma once

#include <optional>

#include "language/macrostep_timing.hpp"
#include "language/speed/speed_override.hpp"
#include "mrroc/move.hpp"
#include "mrroc/step_observer.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

/// One execution of Move (with a generator) or Wait (without): the loop that both share. See `Move` for the algorithm.
class Instruction {
 public:
  /// `generator` null: Wait. Checks the lists; throws NonFatalError(invalid_argument).
  Instruction(const RobotList& robots, const SensorList& sensors, Generator* generator,
              std::shared_ptr<Condition> condition);
  Outcome run();

 private:
  Outcome run_steps();
  void obtain_initial_state();
  /// f_E: throws the most severe error reported by e^i or v^i, the first in the lists among equals.
  void throw_reported_errors() const;
  /// Handles pause (holding), stop (throws) and end-motion (true).
  bool operator_ends_it();
  /// Several robots, whose common way is the generator's.
  bool together() const noexcept;
  /// From now on the steps lead the robots to rest on their way, where `braking_` is true then.
  void begin_braking();
  void end_braking() noexcept;
  /// Whether the last step brakes: the speed cannot stretch every command.
  bool leads_to_rest() const noexcept;
  /// After an error that is not of a robot: robots that move together come to rest on their common way, as far as the
  /// generator can lead them. The steps are not recorded.
  void brake_together();
  /// Whether a robot does not rest.
  bool moving() const noexcept;
  /// Handles the request after the pause; `request` is the present one.
  OperatorRequest hold_until_resumed(OperatorRequest request);
  /// Holds until every robot rests.
  void come_to_rest();
  /// A robot has braked, or started after the others, because its command was late, so the generator's plan is no
  /// longer valid. All robots come to rest, then it plans the rest of the motion.
  void resume_after_late_command();
  std::uint64_t late_commands() const noexcept;
  /// One macrostep in which every robot holds.
  void hold();
  std::optional<Ending> evaluate_end();
  void write_next_state();
  void stop_together() noexcept;
  /// The generator plans again, from rest.
  void resume_generator();
  /// The constant data of the instruction, for the records of the steps.
  void begin_record();
  /// Records the step in the task's black box and passes it to the task's observer.
  void observe(StepEnding ending);
  /// Requests the readings due at `next_step`, then sends e^{i+1}.
  void send(std::uint64_t next_step);
  /// Awaits every reply, then collects the readings due at `next_step`.
  void receive(std::uint64_t next_step);
  void name_group() noexcept;
  void measure_skew() noexcept;

  // ---- equation (11), in instruction_coordination.cpp
  /// In an ECP: the MP takes part if the generator is `Coordinated`. Throws NonFatalError unless it has one robot.
  void join_superior();
  /// Robots come to rest after an error, and both sides of a Move in which the MP takes part know of its end.
  void end_after(const Error& error);
  /// `error`: that ends the instruction, or null.
  void leave_superior(const Error* error);
  /// Takes what the MP has sent, or waits for something to arrive: true when it has commanded this step or has ended.
  bool superior_commands();
  void write_with_superior();
  /// In the MP, before its generator plans again: the ECPs that take part are shown from which state.
  void obtain_if_coordinated();
  /// In the MP: a Move has ended for the ECPs that take part in it.
  void end_coordination();

  /// The tick at which e^{i+1} will be measured.
  Tick next_measurement() const;
  Tick newest_tick() const;
  Tick newest_state() const noexcept;
  Outcome finish(Ending ending) const;

  std::vector<Robot*> robots_;
  std::vector<Sensor*> sensors_;
  Generator* generator_;
  Generator* started_ = nullptr;
  bool leads_ = false;  ///< the generator has started: it can be asked for states
  std::shared_ptr<Condition> condition_;
  std::vector<const Condition*> leaves_;
  Task* task_ = nullptr;
  std::shared_ptr<InstructionRecord> record_;  // numbered when its first step is recorded
  std::uint64_t step_ = 0;                     // i - i0
  bool braking_ = false;                       // on the path: by the generator, or by the speed
  /// In which robots that move together come to rest before the end of their Move, or else brake by themselves.
  static constexpr int kMostBrakingSteps = 500;
  int braking_steps_ = 0;
  OperatorRequest ending_ = OperatorRequest::none;  // what ends the Move when its robots rest
  bool halting_ = false;                            // by the speed
  std::uint64_t held_ = 0;                          // macrosteps of hold since the last command that was observed
  Tick start_tick_ = 0;
  double start_wall_ = 0;
  Tick measure_at_ = 0;
  Tick skew_ = 0;
  std::uint64_t group_ = 0;       // CommonStop::group
  Superior* superior_ = nullptr;  // in an ECP, of a Move in which the MP takes part
  bool obtained_ = false;         // states by a query since the last step that was observed
  SpeedOverride speed_;
  MacrostepTiming timing_;
  std::uint64_t late_ = 0;  ///< late commands of all robots, as known
};

}  // namespace mrroc
