#pragma once

#include "can_rig.hpp"
#include "edp/safety/error_report.hpp"

namespace mrroc::edp {

/// Ticks from an output to the input that it is wired to: two PDOs of inputs.
inline constexpr Tick kSettled = 12;

inline canopen::EdsFile io_eds() {
  return canopen::EdsFile::load(std::filesystem::path(MRROC_SOURCE_DIR) / "src/canopen/cia401.eds");
}

/// Two nodes: 40 with 10 digital inputs and 12 digital outputs, 5 analogue inputs and 2 analogue outputs of 10 V; 41
/// with 6 digital inputs, 4 digital outputs, 3 analogue inputs of 20 mA and 6 analogue outputs.
inline config::IoTable io_table() {
  config::IoTable table;
  table.file = "io";
  table.nodes.resize(2);
  config::IoEntry& first = table.nodes[0];
  first.node = 40;
  first.digital_inputs = {0, 10};
  first.digital_outputs = {0, 12};
  first.analog_inputs = {{0, 5}, 10};
  first.analog_outputs = {{0, 2}, 10};
  config::IoEntry& second = table.nodes[1];
  second.node = 41;
  second.digital_inputs = {10, 6};
  second.digital_outputs = {12, 4};
  second.analog_inputs = {{5, 3}, 20};
  second.analog_outputs = {{2, 6}, 10};
  first.eds = second.eds = io_eds();
  return table;
}

/// A moving gantry with these I/O nodes on its bus. The plant's inputs are its outputs.
struct IoRig : CanRig<Gantry> {
  explicit IoRig(const config::IoTable& io = io_table())
      : CanRig(table_for(Gantry{}.parameters(), canopen::DriveMode::cyclic_position), true, {}, io) {}

  void put_out(const ControllerIo& outputs) {
    RobotCommand command;
    command.kind = CommandKind::set_outputs;
    command.outputs = outputs;
    ASSERT_TRUE(send(command));
    ASSERT_EQ(answer.state.error.error_class, ErrorClass::none) << answer.state.error.detail.view();
  }
  /// From now on the input 12 of node 41, off, presses the emergency stop. It is wired to the output 12, which is on.
  /// Returns the outputs that release it.
  ControllerIo use_emergency_terminal() {
    ControllerIo released;
    released.set(12, true);
    put_out(released);
    run(kSettled);
    servo.use_emergency_stop(operators);
    servo.use_emergency_terminal(12);
    return released;
  }
  /// The outputs as the nodes have them.
  ControllerIo physical() {
    ControllerIo outputs;
    rack.with_io([&outputs](auto& nodes) {
      for (const sim::IoNode& node : nodes) node.drive(outputs);
    });
    return outputs;
  }
  void with_node(std::size_t place, const std::function<void(sim::IoNode&)>& action) {
    rack.with_io([&](std::vector<sim::IoNode>& nodes) { action(nodes[place]); });
  }
  /// `robot.recover()`; its error.
  ErrorCode recover() {
    RobotCommand command;
    command.kind = CommandKind::recover;
    replies.clear();
    if (send(command)) return answer.state.error.code;
    for (int i = 0; i < 2000 && replies.empty(); ++i) tick();
    return replies.empty() ? ErrorCode::busy : replies.back().state.error.code;
  }
  std::string text() const { return std::string(make_report(seen().fault, model.parameters()).detail.view()); }
};

}  // namespace mrroc::edp
