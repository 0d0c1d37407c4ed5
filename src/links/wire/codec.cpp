#include "links/wire/codec.hpp"

#include <utility>

#include "links/wire/fields.hpp"

namespace mrroc::links {
namespace {

/// A part of a message that has fields itself.
template <class T>
concept Composite = Is<T, ErrorReport> || Is<T, ControllerIo> || Is<T, Message> || Is<T, ForceLaw> || Is<T, Counters>;

struct Put {
  template <class T, class Wire>
  bool field(const T& value, Wire& wire) const noexcept {
    if constexpr (Composite<T>)
      visit_fields(value, wire, *this);
    else
      put(value, wire);
    return true;
  }
  template <class T>
  bool count(T value, T& wire, std::size_t /*most*/) const noexcept {
    wire = value;
    return true;
  }
};

struct Valid {
  template <class T, class Wire>
  bool field(const T& value, const Wire& wire) const noexcept {
    if constexpr (Composite<T>)
      return visit_fields(value, wire, *this);
    else
      return is_valid(Value<T>{}, wire);
  }
  template <class T>
  bool count(T /*value*/, T wire, std::size_t most) const noexcept {
    return wire <= most;
  }
};

struct Get {
  template <class T, class Wire>
  bool field(T& value, const Wire& wire) const noexcept {
    if constexpr (Composite<T>)
      visit_fields(value, wire, *this);
    else
      get(wire, value);
    return true;
  }
  template <class T>
  bool count(T& value, T wire, std::size_t /*most*/) const noexcept {
    value = wire;
    return true;
  }
};

}  // namespace

template <class T>
void encode(const T& message, Wire<T>& wire) noexcept {
  visit_fields(message, wire, Put{});
}

template <class T>
bool valid(const Wire<T>& wire) noexcept {
  const T types{};  // the check looks at the types of the fields only
  return visit_fields(types, wire, Valid{});
}

template <class T>
bool decode(const Wire<T>& wire, T& message) noexcept {
  return visit_fields(std::as_const(message), wire, Valid{}) && visit_fields(message, wire, Get{});
}

template void encode(const RobotCommand&, Wire<RobotCommand>&) noexcept;
template void encode(const RobotState&, Wire<RobotState>&) noexcept;
template void encode(const SensorRequest&, Wire<SensorRequest>&) noexcept;
template void encode(const SensorReading&, Wire<SensorReading>&) noexcept;
template void encode(const TaskCommand&, Wire<TaskCommand>&) noexcept;
template void encode(const TaskStatus&, Wire<TaskStatus>&) noexcept;
template void encode(const OperatorQuestion&, Wire<OperatorQuestion>&) noexcept;
template void encode(const OperatorAnswer&, Wire<OperatorAnswer>&) noexcept;
template void encode(const TrajectoryPart&, Wire<TrajectoryPart>&) noexcept;
template void encode(const TrajectoryReport&, Wire<TrajectoryReport>&) noexcept;
template void encode(const ProcessStatus&, Wire<ProcessStatus>&) noexcept;

template bool valid<RobotCommand>(const Wire<RobotCommand>&) noexcept;
template bool valid<RobotState>(const Wire<RobotState>&) noexcept;
template bool valid<SensorRequest>(const Wire<SensorRequest>&) noexcept;
template bool valid<SensorReading>(const Wire<SensorReading>&) noexcept;
template bool valid<TaskCommand>(const Wire<TaskCommand>&) noexcept;
template bool valid<TaskStatus>(const Wire<TaskStatus>&) noexcept;
template bool valid<OperatorQuestion>(const Wire<OperatorQuestion>&) noexcept;
template bool valid<OperatorAnswer>(const Wire<OperatorAnswer>&) noexcept;
template bool valid<TrajectoryPart>(const Wire<TrajectoryPart>&) noexcept;
template bool valid<TrajectoryReport>(const Wire<TrajectoryReport>&) noexcept;

template bool decode(const Wire<RobotCommand>&, RobotCommand&) noexcept;
template bool decode(const Wire<RobotState>&, RobotState&) noexcept;
template bool decode(const Wire<SensorRequest>&, SensorRequest&) noexcept;
template bool decode(const Wire<SensorReading>&, SensorReading&) noexcept;
template bool decode(const Wire<TaskCommand>&, TaskCommand&) noexcept;
template bool decode(const Wire<TaskStatus>&, TaskStatus&) noexcept;
template bool decode(const Wire<OperatorQuestion>&, OperatorQuestion&) noexcept;
template bool decode(const Wire<OperatorAnswer>&, OperatorAnswer&) noexcept;
template bool decode(const Wire<TrajectoryPart>&, TrajectoryPart&) noexcept;
template bool decode(const Wire<TrajectoryReport>&, TrajectoryReport&) noexcept;
template bool decode(const Wire<ProcessStatus>&, ProcessStatus&) noexcept;

}  // namespace mrroc::links
