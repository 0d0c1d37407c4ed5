#include "sim/can/drive_rack.hpp"

#include <algorithm>
#include <cmath>

#include "can/fence.hpp"
#include "clock/wall/monotonic.hpp"

namespace mrroc::sim {

using namespace canopen;

namespace {

constexpr std::int64_t kGlance = 2'000'000;  // ns: between two checks of the time and of `stop`
constexpr double kOldest = 10;               // periods for which a shaft is extrapolated

}  // namespace

DriveRack::DriveRack(const config::DriveTable& table, const RobotParameters& robot, double period, can::Bus& bus,
                     edp::Hardware& plant, PlantTick plant_tick, Time time, AtCycle at_cycle, const config::IoTable& io)
    : bus_(bus),
      plant_(plant),
      plant_tick_(std::move(plant_tick)),
      time_(time),
      master_(table.master),
      sync_(table.sync),
      at_cycle_(std::move(at_cycle)),
      period_(std::llround(period * 1e9)) {
  nodes_.reserve(robot.axes.size());
  for (std::size_t i = 0; i < robot.axes.size(); ++i)
    nodes_.emplace_back(table, table.drives[i], robot.axes[i], period,
                        [this](const can::Frame& frame) { bus_.send(frame); });
  io_nodes_.reserve(io.nodes.size());
  for (const config::IoEntry& entry : io.nodes)
    io_nodes_.emplace_back(entry, [this](const can::Frame& frame) { bus_.send(frame); });
}

std::int64_t DriveRack::now() const noexcept {
  return time_ == Time::wall ? clock::monotonic_ns() : static_cast<std::int64_t>(tick_ + 1) * period_;
}

void DriveRack::with(const std::function<void(std::vector<DriveNode>&)>& action) {
  const std::lock_guard lock(mutex_);
  action(nodes_);
}

void DriveRack::with_io(const std::function<void(std::vector<IoNode>&)>& action) {
  const std::lock_guard lock(mutex_);
  action(io_nodes_);
}

bool DriveRack::any_powered() const noexcept {
  return std::any_of(nodes_.begin(), nodes_.end(), [](const DriveNode& node) { return node.powered(); });
}

bool DriveRack::all_commanded() const noexcept {
  return std::none_of(nodes_.begin(), nodes_.end(), [](const DriveNode& node) { return node.waits_for_command(); });
}

void DriveRack::serve() {
  with([this](std::vector<DriveNode>& nodes) {
    for (DriveNode& node : nodes) node.boot(now());
    for (IoNode& node : io_nodes_) node.boot(now());
  });
  while (!stop_.load()) {
    can::Frame frame;
    const bool came = bus_.receive(frame, clock::monotonic_ns() + kGlance);
    const std::lock_guard lock(mutex_);
    if (came) take(frame);
    for (DriveNode& node : nodes_) node.update(now());
    for (IoNode& node : io_nodes_) node.update(now());
    const std::int64_t since = clock::monotonic_ns() - synced_;
    // lost set-points: the bus has lost a frame, or the master has died
    if (open_ && time_ == Time::wall && since > period_) drive();
    if (time_ == Time::wall && any_powered() && since > 2 * period_) begin_cycle(false);
  }
}

void DriveRack::take(const can::Frame& frame) {
  if (!frame.error && frame.id == sync_) {
    if (open_) drive();
    begin_cycle(true);
    return;
  }
  if (const auto fence = can::fence_of(frame, can::kFence)) {
    if (fence->master != master_) return;
    if (fence->ends_cycle && open_) drive();
    bus_.send(can::to_frame(*fence, can::kReturnedFence));
    return;
  }
  for (DriveNode& node : nodes_) node.take(frame, now());
  for (IoNode& node : io_nodes_) node.take(frame, now());
  if (open_ && all_commanded()) drive();
}

void DriveRack::begin_cycle(bool on_bus) {
  synced_ = clock::monotonic_ns();
  measure();
  ControllerIo inputs = input_.inputs;
  if (at_cycle_) at_cycle_({tick_, now(), nodes_, io_nodes_, inputs});
  for (IoNode& node : io_nodes_) node.measure(inputs);
  open_ = true;
  if (!on_bus) return drive();
  cycles_.fetch_add(1);
  for (DriveNode& node : nodes_) node.synchronise();
  // PDOs that the master does not wait for come first, so that they have arrived when the others have
  for (IoNode& node : io_nodes_) node.synchronise();
  for (DriveNode& node : nodes_) node.send_status();
  for (DriveNode& node : nodes_) node.send_feedback();
  if (all_commanded()) drive();
}

void DriveRack::measure() {
  const Newest newest = plant_tick_(tick_, any_powered(), synced_);
  const JointVector last = input_.motors;
  input_.time = static_cast<double>(newest.tick);
  plant_.read(newest.tick, input_);
  if (last.size() == 0) per_period_.setZero(input_.motors.size());
  const auto measured = static_cast<Tick>(input_.time);
  if (measured > tick_ && last.size() != 0)
    per_period_ = (input_.motors - last) / static_cast<double>(measured - tick_);
  tick_ = measured;
  const double age = std::clamp(newest.age, -kOldest, kOldest);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    nodes_[i].measure(input_.motors[k] + age * per_period_[k], input_.current[k], input_.switches[i]);
  }
}

void DriveRack::drive() {
  open_ = false;
  const bool let_go = std::all_of(nodes_.begin(), nodes_.end(), [](const DriveNode& node) { return node.powered(); });
  JointVector current(static_cast<Eigen::Index>(nodes_.size()));
  for (std::size_t i = 0; i < nodes_.size(); ++i) current[static_cast<Eigen::Index>(i)] = nodes_[i].drive();
  powered_.store(any_powered());
  if (let_go != let_go_) plant_.enable(let_go);
  let_go_ = let_go;
  ControllerIo outputs;
  for (const IoNode& node : io_nodes_) node.drive(outputs);
  plant_.set_outputs(outputs);
  plant_.write(tick_, current);
}

}  // namespace mrroc::sim
