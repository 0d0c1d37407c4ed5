#pragma once

#include <rapidcheck.h>

#include "language/random_values.hpp"
#include "language/script.hpp"

namespace mrroc::fakes {

namespace detail {

/// Shrinks to false.
inline bool chance(int percent) { return pick(0, 99) >= 100 - percent; }

inline RobotScript random_robot() {
  RobotScript robot;
  robot.motion_steps = chance(50) ? 10 : pick(1, 40);
  robot.reply_step = pick(1, robot.motion_steps + 1);
  robot.addressed = chance(70);
  robot.moving = chance(60);
  return robot;
}

inline SensorScript random_sensor() {
  SensorScript sensor;
  sensor.interactive = chance(50);
  sensor.period = static_cast<std::uint32_t>(pick(1, 5));
  if (!sensor.interactive && chance(10)) sensor.ready_from = static_cast<std::uint64_t>(pick(0, 3));
  return sensor;
}

/// True never, from some step on, occasionally, or always.
inline LeafScript random_leaf() {
  LeafScript leaf;
  leaf.red = chance(50);
  const int kind = pick(0, 9);
  if (kind < 3) leaf.pattern = 0;
  if (kind >= 3 && kind < 7) leaf.pattern = ~std::uint64_t{0} << pick(0, 25);
  if (kind >= 7 && kind < 9) leaf.pattern = std::uint64_t{1} << pick(0, 40) | std::uint64_t{1} << pick(0, 40);
  if (kind == 9) leaf.pattern = ~std::uint64_t{0};
  return leaf;
}

inline OperatorRequest random_request() {
  const int percent = pick(0, 99);
  if (percent < 88) return OperatorRequest::none;
  if (percent < 97) return OperatorRequest::pause;
  return percent < 98 ? OperatorRequest::stop : OperatorRequest::end_motion;
}

inline FaultScript random_fault(const Script& script) {
  static constexpr ErrorCode codes[] = {ErrorCode::busy, ErrorCode::singular, ErrorCode::drive_fault,
                                        ErrorCode::sensor_hardware, ErrorCode::process_died};
  FaultScript fault;
  fault.of_robot = script.sensors.empty() || (!script.robots.empty() && chance(50));
  fault.device = static_cast<std::size_t>(
      pick(0, static_cast<int>(fault.of_robot ? script.robots.size() : script.sensors.size()) - 1));
  fault.reception = static_cast<std::uint64_t>(pick(0, 15));
  fault.error_class = static_cast<ErrorClass>(pick(1, 3));
  fault.code = codes[pick(0, 4)];
  return fault;
}

}  // namespace detail

/// A tree of up to `size` combinations over the script's leaves: every node is used once, leaves may be used again.
inline void add_random_tree(Script& script, int size) {
  using namespace detail;
  for (int i = 0, n = pick(1, 4); i < n; ++i) script.leaves.push_back(random_leaf());
  std::vector<std::size_t> loose;  // nodes without a parent
  const auto add = [&](NodeScript node) {
    node.named = node.kind != NodeScript::Kind::leaf && chance(25);
    script.nodes.push_back(node);
    loose.push_back(script.nodes.size() - 1);
  };
  const auto take = [&] {
    const auto place = loose.begin() + pick(0, static_cast<int>(loose.size()) - 1);
    const std::size_t node = *place;
    loose.erase(place);
    return node;
  };
  const auto add_leaf = [&] {
    add({NodeScript::Kind::leaf, static_cast<std::size_t>(pick(0, static_cast<int>(script.leaves.size()) - 1)), 0,
         false});
  };
  add_leaf();
  for (int i = 0, n = pick(0, size); i < n; ++i) {
    const auto kind = static_cast<NodeScript::Kind>(pick(1, 3));
    if (kind == NodeScript::Kind::negated) {
      add({kind, take(), 0, false});
    } else {
      if (loose.size() < 2 || chance(40)) add_leaf();
      const std::size_t a = take();
      add({kind, a, take(), false});
    }
  }
  while (loose.size() > 1) {
    const std::size_t a = take();
    add({NodeScript::Kind::either, a, take(), false});
  }
}

/// Common parameters of the random scripts of one property.
struct ScriptOptions {
  std::optional<bool> is_move = std::nullopt;
  int fewest_robots = 0;
  bool faults = true;
  bool pauses = true;
};

/// 1..5 robots (or none, with sensors), 0..4 sensors, a condition, at most 40 steps and pauses.
inline Script random_script(const ScriptOptions& options = {}) {
  using namespace detail;
  Script script;
  script.is_move = options.is_move.value_or(chance(60));
  const int robots = options.fewest_robots == 0 && chance(10) ? 0 : pick(std::max(1, options.fewest_robots), 5);
  for (int i = 0; i < robots; ++i) script.robots.push_back(random_robot());
  for (int i = 0, n = pick(robots == 0 ? 1 : 0, 4); i < n; ++i) script.sensors.push_back(random_sensor());
  if (!script.is_move || chance(70)) add_random_tree(script, 6);
  if (script.is_move && chance(60)) script.generator_ends = static_cast<std::uint64_t>(pick(0, 30));
  if (options.faults && chance(40)) {
    for (int i = 0, n = pick(1, 3); i < n; ++i) script.faults.push_back(random_fault(script));
  }
  if (!options.faults) {
    for (SensorScript& sensor : script.sensors) sensor.ready_from = 0;
  }
  const int requests = pick(0, 40);
  const bool quiet = !options.pauses || chance(50);
  for (int i = 0; i < requests; ++i) script.requests.push_back(quiet ? OperatorRequest::none : random_request());
  script.requests.push_back(OperatorRequest::end_motion);
  return script;
}

}  // namespace mrroc::fakes
