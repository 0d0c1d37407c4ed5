#pragma once

#include <array>
#include <functional>
#include <initializer_list>
#include <vector>

#include "mrroc/generator.hpp"
#include "mrroc/outcome.hpp"
#include "mrroc/robot.hpp"
#include "mrroc/sensor.hpp"

namespace mrroc {

/// The paper's lists of robots and of sensors: written `{left, right}`, or built from a vector. Refers to its elements.
template <class Element>
class ListOf {
 public:
  ListOf() = default;
  ListOf(std::initializer_list<std::reference_wrapper<Element>> elements) {
    for (Element& element : elements) elements_.push_back(&element);
  }
  /// No null pointers.
  explicit ListOf(const std::vector<Element*>& elements) : elements_(elements) {}

  auto begin() const noexcept { return elements_.begin(); }
  auto end() const noexcept { return elements_.end(); }
  std::size_t size() const noexcept { return elements_.size(); }
  bool empty() const noexcept { return elements_.empty(); }
  Element& front() const { return *elements_.front(); }

 private:
  std::vector<Element*> elements_;
};

using RobotList = ListOf<Robot>;
using SensorList = ListOf<Sensor>;

/// `Move`, the paper's equation (5) and figure 2:
///
///     obtain e^i, v^i                            (i = i0)
///     repeat
///       f_E: the most severe error reported by e^i or v^i is thrown, with its class
///       a robot has braked because its command came late: all come to rest, then generator.resume()
///       the operator: pause holds every robot until resume; stop throws Stopped; end-motion returns
///       f_T: generator.terminal_condition() or the condition of `until` holds: return
///       e^{i+1} = f_e*(c^i, e^i, v^i): generator.next_state() writes the commands
///       initiate the readings due at i+1; send all commands; await all replies; collect the readings due;  i = i+1
///
/// A Move whose f_T holds at i0 commands nothing. The first command may depend on v^{i0}. The robots are commanded
/// together, awaited together, and begin the step on the same tick. Without robots a step lasts 10 ticks. Nothing is
/// allocated from the second step on. Throws Error, Stopped; NonFatalError(invalid_argument) when both lists are empty,
/// a robot or sensor is listed twice, or they belong to different tasks. Task's thread.
Outcome Move(const RobotList& robots, const SensorList& sensors, Generator& generator);
inline Outcome Move(const RobotList& robots, const SensorList& sensors, Generator&& generator) {
  return Move(robots, sensors, generator);
}

/// `Wait`, the paper's equation (3) and figure 1: as `Move`, but every robot holds (e^{i+1} = e^i) until f_I holds.
Outcome Wait(const RobotList& robots, const SensorList& sensors, std::shared_ptr<Condition> condition);
template <ConditionType C>
Outcome Wait(const RobotList& robots, const SensorList& sensors, C condition) {
  return Wait(robots, sensors, std::static_pointer_cast<Condition>(std::make_shared<C>(std::move(condition))));
}

}  // namespace mrroc
