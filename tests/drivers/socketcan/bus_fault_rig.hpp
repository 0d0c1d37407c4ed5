#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <random>
#include <string>

#include "can_rig.hpp"
#include "clock/wall/monotonic.hpp"
#include "edp/safety/error_report.hpp"
#include "repetitions.hpp"

namespace mrroc::edp {

inline constexpr int kAxis = 2;  // z, node 3

/// A bus whose transmit queue can be full, whose interface can be down, and which can lose SYNCs. It records what its
/// owner receives in time.
class WeakBus : public can::Bus {
 public:
  explicit WeakBus(std::unique_ptr<can::Bus> bus) : bus_(std::move(bus)) {}
  can::Sent send(const can::Frame& frame) noexcept override {
    if (frame.id == canopen::kSync) {
      answers_ = 0;
      synced_ = clock::monotonic_ns();
      if (loses_syncs) return can::Sent::yes;
    } else if (frame.id == canopen::kReceivePdo1 + 1) {  // the first set-point: the driver no longer waits for answers
      ++cycles;
      if (answers_ != kAllAnswers) ++unanswered;
      if (clock::monotonic_ns() - synced_ > kSlow) ++slow;
    }
    if (is_off) return can::Sent::yes;
    return answer == can::Sent::yes ? bus_->send(frame) : answer;
  }
  bool receive(can::Frame& frame, std::int64_t deadline) noexcept override {
    do {
      if (!bus_->receive(frame, deadline)) return false;
    } while (is_off && !frame.error);
    if (goes_off && frame.error) is_off = true;
    if (const std::uint32_t node = frame.id - canopen::kTransmitPdo1; node >= 1 && node <= 4) answers_ |= 1u << node;
    return true;
  }
  void filter(std::span<const can::Filter> filters) override { bus_->filter(filters); }
  int descriptor() const noexcept override { return bus_->descriptor(); }
  bool carries_fd() const noexcept override { return bus_->carries_fd(); }
  can::Sent answer = can::Sent::yes;
  bool loses_syncs = false;
  bool goes_off = false;  ///< at the next error frame
  bool is_off = false;    ///< like a controller in bus-off: no frames in either direction, and no report of the kernel
  // counts of cycles, of cycles with missing answers, of cycles with late answers
  int cycles = 0, unanswered = 0, slow = 0;

 private:
  static constexpr unsigned kAllAnswers = 0b11110;  // of nodes 1 to 4
  static constexpr std::int64_t kSlow = clock::kSecond / 1000;
  std::unique_ptr<can::Bus> bus_;
  unsigned answers_ = 0;
  std::int64_t synced_ = 0;
};

/// As in the robots' files: an axis that reads the same position while it is commanded to move is stuck.
class Watched : public Gantry {
 public:
  Watched() {
    for (AxisParameters& axis : parameters_.axes) {
      axis.following_error_max = 1;
      axis.stuck_max = 0.25;
    }
  }
};

inline config::DriveTable watched_table(bool absolute_encoders, double ramp) {
  config::DriveTable table = table_for(Watched{}.parameters(), canopen::DriveMode::cyclic_position);
  table.absolute_encoders = absolute_encoders;
  for (config::DriveEntry& drive : table.drives) {
    if (ramp == 0) continue;
    const double units = ramp * drive.units_per_turn / (2 * std::numbers::pi);
    drive.settings.push_back({{0x6085}, "Quick stop deceleration", std::lround(units), 4});
  }
  return table;
}

/// Decides about the frames of a hub, whose thread asks while a test changes the rule.
class Spoiler {
 public:
  /// From now on; without `how` all frames pass.
  void use(can::Hub::Disturbance how) {
    const std::lock_guard lock(mutex_);
    how_ = std::move(how);
  }
  bool pass(can::Frame& frame) {
    const std::lock_guard lock(mutex_);
    return !how_ || how_(frame);
  }

 private:
  std::mutex mutex_;
  can::Hub::Disturbance how_;
};

/// A gantry in motion, with all faults available.
class Rig {
 public:
  /// `ramp` in rad/s^2: of the drives' stops, 0: their default ramp.
  explicit Rig(unsigned seed, bool absolute_encoders = true, double ramp = 0, CanHardware::Timing timing = kTestTiming)
      : random(seed),
        table(watched_table(absolute_encoders, ramp)),
        bus([this](can::Frame& frame) { return spoil.pass(frame); }),
        rack(table, model, bus, true) {
    const auto open = [this] {
      auto weak = std::make_unique<WeakBus>(bus.open());
      weak_bus = weak.get();
      return weak;
    };
    hardware = std::make_unique<CanHardware>(table, model.parameters(), kCanPeriod, open, timing, true);
    hardware->open();
    servo = std::make_unique<Servo>(models, *hardware, kCanPeriod, hand_over);
    effector.enable(true);
    while (!servo->snapshot().enabled() && now < 3000) tick();
    effector.accept(relative_joints(JointVector::Constant(4, kFirstWay), 1500), ++number, answer);
    const Tick moment = now + 50 + random() % 1000;
    while (now < moment) tick();
  }

  void tick() {
    if (before_tick) before_tick();
    const std::uint64_t cycles = rack.cycles();
    servo->tick(now++);
    if (!servo->drives_on()) await_cycle_after(cycles);  // no answers pace the ticks
    Reply reply;
    while (effector.poll(reply)) last = reply;
    const Snapshot& seen = servo->snapshot();
    for (int i = 0; i < 4; ++i) {
      const AxisParameters& axis = model.parameters().axes[static_cast<std::size_t>(i)];
      worst_speed = std::max(worst_speed, std::abs(seen.desired.velocity[i]) / axis.velocity_max);
      worst_position = std::max(worst_position, std::abs(seen.desired.position[i]) / axis.position_max);
    }
    const JointVector shafts = rack.shafts();
    const double way = kFirstWay + kSecondWay;
    off_its_way =
        std::max({off_its_way, shafts.maxCoeff() / GearedModel::kGear - way, -shafts.minCoeff() / GearedModel::kGear});
    if (shafts_.size() != 0) {
      const double speed = ((shafts - shafts_) / kCanPeriod / GearedModel::kGear).cwiseAbs().maxCoeff();
      worst_real_speed = std::max(worst_real_speed, speed / model.parameters().axes[0].velocity_max);
    }
    shafts_ = shafts;
    past_.push_back(shafts);
    if (past_.size() <= kWindow) return;
    const double mean = ((shafts - past_.front()) / (kWindow * kCanPeriod) / GearedModel::kGear).cwiseAbs().maxCoeff();
    worst_mean_speed = std::max(worst_mean_speed, mean / model.parameters().axes[0].velocity_max);
    past_.pop_front();
  }
  /// Ticks until the servo has found a fault and its drives are off; then no axis may move. Drives that `hear` their
  /// master have taken its last commands by then: on a busy machine their thread lags behind unpaced ticks.
  void stop(bool hear = true) {
    const Tick begin = now;
    while ((servo->snapshot().fault.code == ErrorCode::none || servo->drives_on()) && now < begin + 3000) tick();
    stopped_after = now - begin;
    for (int i = 0; i < 300; ++i) tick();  // the drives' own ramps and watchdogs
    for (int i = 0; i < 5000 && hear && operates(); ++i) {
      tick();
      ::usleep(2000);
    }
    const JointVector there = rack.shafts();
    for (int i = 0; i < 50; ++i) tick();
    for (int i = 0; i < 5; ++i) {
      tick();
      ::usleep(2000);  // without answers ticks are too short for the bus to carry their frames
    }
    moved = (rack.shafts() - there).cwiseAbs().maxCoeff();
  }
  /// Waits until the bus has carried the unpaced frames of the fault, and frames arrive in order again.
  void settle() {
    paced_ = true;
    for (int i = 0; i < 60; ++i) tick();
    paced_ = false;
  }
  bool recover() {
    RobotCommand command;
    command.kind = CommandKind::recover;
    last = {};
    if (effector.accept(command, ++number, answer)) return false;
    paced_ = true;
    for (int i = 0; i < 4000 && last.command != number; ++i) tick();
    paced_ = false;
    return last.command == number && last.state.error.error_class == ErrorClass::none;
  }
  bool moves_again() {
    if (effector.accept(relative_joints(JointVector::Constant(4, kSecondWay), 400), ++number, answer)) return false;
    for (int i = 0; i < 500; ++i) tick();
    return last.command == number && last.state.error.error_class == ErrorClass::none;
  }
  const Fault& fault() const { return servo->snapshot().fault; }
  std::string text() const { return std::string(make_report(fault(), model.parameters()).detail.view()); }
  /// Whether a drive still follows set-points, or has power at all.
  bool operates() {
    return any([](const sim::DriveNode& node) { return node.state() == canopen::DriveState::operation_enabled; });
  }
  bool powered() {
    return any([](const sim::DriveNode& node) { return node.powered(); });
  }
  sim::DriveNode& node(std::vector<sim::DriveNode>& nodes) const { return nodes[kAxis]; }

  std::mt19937 random;
  Watched model;
  config::DriveTable table;
  Spoiler spoil;
  TestBus bus;
  Rack rack;
  WeakBus* weak_bus = nullptr;
  std::unique_ptr<CanHardware> hardware;
  ServoChannel hand_over;
  ModelSet models{model};
  std::unique_ptr<Servo> servo;
  Effector effector{models, kCanPeriod, hand_over};
  Tick now = 0;
  std::uint64_t number = 0;
  Reply answer, last;
  /// Parts of the limit: of the set-points, of the shafts from tick to tick and in kWindow ticks; rad after the stop.
  double worst_speed = 0, worst_real_speed = 0, worst_mean_speed = 0, moved = 0;
  /// Of the set-points, a part of the limit; of the shafts, distance beyond either end of the path, rad of a joint.
  double worst_position = 0, off_its_way = 0;
  Tick stopped_after = 0;
  std::function<void()> before_tick;  ///< other traffic on the bus

 private:
  bool any(const std::function<bool(const sim::DriveNode&)>& is) {
    bool found = false;
    rack.with([&](auto& nodes) { found = std::any_of(nodes.begin(), nodes.end(), is); });
    return found;
  }

  /// Waits until drives without awaited answers have received the SYNC, or the bus has had the time for it. The
  /// driver's timeouts in ticks, for example for a restarted drive, must not expire while the drives' thread has no
  /// processor.
  void await_cycle_after(std::uint64_t cycles) {
    const int glances = paced_ && !weak_bus->is_off ? 4000 : 1;
    for (int i = 0; i < glances && rack.cycles() == cycles; ++i) ::usleep(50);
  }

  static constexpr std::size_t kWindow = 10;
  static constexpr double kFirstWay = 0.6, kSecondWay = 0.02;  // rad of each joint, from 0 on
  JointVector shafts_;
  std::deque<JointVector> past_;
  bool paced_ = false;
};

/// On the kernel's sockets: a command of ip(8) or tc(8) about the interface, "DEV" in it. Root.
inline void interface(const Rig& rig, std::string command) {
  command.replace(command.find("DEV"), 3, rig.bus.name());
  command.insert(0, "PATH=$PATH:/usr/sbin:/sbin ");
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

/// The kernel's treatment of each frame from now on (tc-netem(8)), where a program's own loop-back passes the queue.
inline void disturb(const Rig& rig, const std::string& netem) {
  interface(rig, "tc qdisc replace dev DEV root netem " + netem);
}

inline void leave_in_peace(const Rig& rig) { interface(rig, "tc qdisc del dev DEV root"); }

/// Number of random moments for each fault: MRROC_TEST_SEEDS; without it 6, with MRROC_TEST_THOROUGH 20.
inline unsigned seeds() {
  const char* const given = std::getenv("MRROC_TEST_SEEDS");
  return static_cast<unsigned>(given != nullptr ? std::atoi(given) : test::tries(6, 20));
}

}  // namespace mrroc::edp
