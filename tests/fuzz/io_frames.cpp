// Frames of any content in any order: the EDP's side of CiA 401 nodes, and simulated ones.
#include <cmath>
#include <filesystem>

#include "drivers/socketcan/io_nodes.hpp"
#include "fuzz/can_frame.hpp"
#include "sim/can/io_node.hpp"

namespace {

using namespace mrroc;
using namespace mrroc::canopen;
using fuzz::check_sent;

constexpr Tick kReset = 50;  // ticks between two attempts to recover

void check_finite(const ControllerIo& io) {
  for (const double value : io.analog) fuzz::require(std::isfinite(value), "an analogue value is a number");
}

/// Node 1 with every terminal; `split`: nodes 1 and 2 with half of them each.
config::IoTable table_of(bool split) {
  config::IoTable table;
  table.nodes.resize(split ? 2 : 1);
  for (config::IoEntry& node : table.nodes) {
    const int place = static_cast<int>(&node - table.nodes.data());
    const int digital = split ? 8 : 16, analog = split ? 4 : 8;
    node.node = static_cast<NodeId>(1 + place);
    node.digital_inputs = node.digital_outputs = {place * digital, digital};
    node.analog_inputs = node.analog_outputs = {{place * analog, analog}, 10};
    node.eds = EdsFile::load(std::filesystem::path(MRROC_SOURCE_DIR) / "src/canopen/cia401.eds");
  }
  return table;
}

/// The EDP's side, ticks at each SYNC. The outputs are the inputs of the tick before.
class IoMaster {
 public:
  explicit IoMaster(const config::IoTable& table) : nodes_(table, {}, 0.002) {
    for (edp::IoNode& node : nodes_.all()) node.begin(0);
  }

  void take(const can::Frame& frame) {
    can::Frame next;
    int takers = 0;
    for (edp::IoNode& node : nodes_.all()) {
      if (node.take(frame, tick_, next)) ++takers;
      check_sent(next);
    }
    fuzz::require(takers <= 1, "a frame is from one node");
    if (frame.id != kSync) return;
    ++tick_;
    edp::HardwareInput input;
    nodes_.read(tick_, input);
    check_finite(input.inputs);
    fuzz::require(input.fault == ErrorCode::none || input.fault == ErrorCode::io_fault, "the fault is of an I/O node");
    nodes_.set_outputs(input.inputs);
    for (edp::IoNode& node : nodes_.all()) step(node);
  }

 private:
  void step(edp::IoNode& node) {
    can::Frame next;
    node.expect();
    if (tick_ % kReset == 0) node.reset(tick_, next);
    check_sent(next);
    if (node.repeats(tick_, next)) check_sent(next);
    for (int number = 1; number <= edp::IoPdos::kCount; ++number) {
      const can::Frame command = node.command(number, nodes_.outputs(), tick_);
      check_sent(command);
      fuzz::require(command.size == 0 || node.is_command(command), "a command is that of its node");
    }
    const edp::IoFault fault = node.fault(tick_);
    const edp::DriverText text = describe(node.node(), fault);
    fuzz::require(text.view().empty() == std::holds_alternative<std::monostate>(fault), "every fault has a text");
    node.busy(tick_);
  }

  edp::IoNodes nodes_;
  Tick tick_ = 0;
};

/// Simulated nodes whose inputs are their outputs.
class IoSlaves {
 public:
  explicit IoSlaves(const config::IoTable& table) {
    for (const config::IoEntry& entry : table.nodes) nodes_.emplace_back(entry, &fuzz::check_sent);
  }

  void boot() {
    now_ = 0;
    for (sim::IoNode& node : nodes_) node.boot(now_);
  }

  void take(const can::Frame& frame) {
    now_ += 1'000'000;
    ControllerIo outputs;
    for (sim::IoNode& node : nodes_) {
      node.take(frame, now_);
      node.update(now_);
      node.drive(outputs);
    }
    check_finite(outputs);
    if (frame.id != kSync || frame.error) return;
    for (sim::IoNode& node : nodes_) {
      node.measure(outputs);
      node.synchronise();
    }
  }

 private:
  std::vector<sim::IoNode> nodes_;
  std::int64_t now_ = 0;
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // reading an EDS file takes longer than the frames: of nodes that have just been switched on
  static const config::IoTable tables[] = {table_of(false), table_of(true)};
  static const IoMaster masters[] = {IoMaster(tables[0]), IoMaster(tables[1])};
  static IoSlaves all_slaves[] = {IoSlaves(tables[0]), IoSlaves(tables[1])};
  fuzz::Bytes input(data, size);
  const std::size_t split = input.take<std::uint8_t>() % 2;
  IoMaster master = masters[split];
  IoSlaves& slaves = all_slaves[split];
  slaves.boot();
  while (!input.empty()) {
    const can::Frame frame = fuzz::take_frame(input);
    master.take(frame);
    slaves.take(frame);
  }
  return 0;
}
