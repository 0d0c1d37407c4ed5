#pragma once

#include <memory>

#include "clock/clock.hpp"
#include "links/transport/domain.hpp"
#include "links/transport/endpoint.hpp"

namespace mrroc::links {

template <class T>
class Reader;

struct WriterOptions {
  bool counted = true;  ///< the clock counts its messages; false if simulated time need not wait for them
};

/// The one writer of a topic. T is a message of src/links/wire/messages.idl: RobotCommand, RobotState, SensorRequest,
/// SensorReading, TaskCommand, TaskStatus, OperatorQuestion, OperatorAnswer, TrajectoryPart, TrajectoryReport.
/// Construct before the clock starts; the domain and the clock outlive it.
template <class T>
class Writer final : public WriterBase {
 public:
  /// Throws SystemError: a bad topic name (configuration), an error of DDS (resources).
  Writer(Domain& domain, clock::Clock& clock, const std::string& topic, WriterOptions options = {});
  ~Writer() override;

  /// Sends one message; never waits. `answers`: boot of the process whose request this answers. One thread. Nothing is
  /// allocated here, but Cyclone allocates twice: never from a servo tick. Throws SystemError (link_lost) when DDS
  /// refuses it.
  void write(const T& message, std::uint64_t sequence, std::uint64_t answers = 0);

  const std::string& topic() const noexcept override;
  void ping() noexcept override;
  void pong(std::uint64_t boot) noexcept override;
  std::string problem() const override;
  /// The DDS writer.
  std::int32_t entity() const noexcept;

 private:
  friend class Reader<T>;
  /// Sends `sample`, the wire form of a T, with a header of this writer.
  void send(void* sample, std::uint64_t sequence, std::uint64_t answers);

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mrroc::links
