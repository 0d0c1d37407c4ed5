#pragma once

#include <vector>

#include "language/speed/own_macrostep.hpp"
#include "language/speed/speed_ramp.hpp"
#include "mrroc/generator.hpp"

namespace mrroc {

/// The operator's speed in one Move: stretches the time between the states that a generator commands, for all robots of
/// the Move together, so that they pass the same paths in step. docs/decisions/0033-speed-override.md.
///
/// The generator commands macrosteps of N ticks in its own time. With the time scale s their paths are executed in
/// pieces: position q(tau), velocity s dq/dtau, acceleration s^2 d2q/dtau2 + ds/dt dq/dtau. A piece takes about N ticks
/// of the clock, so that conditions, readings and the operator act as often as at full speed. Pieces end at whole
/// ticks: the last one of a macrostep ends with it where that is a whole tick, or where all robots come to rest, and
/// otherwise up to a tick before, from where the next macrostep continues.
///
/// s changes with a bounded rate, and only as fast as the limits of every robot allow. While all robots rest it changes
/// at once. With s = 1 the commands are those of the generator, bit for bit. Task's thread; allocates nothing but in
/// its constructor, never throws.
class SpeedOverride {
 public:
  /// `robots` must outlive it. `generator` null: a Wait; nothing is scaled then.
  SpeedOverride(const std::vector<Robot*>& robots, const Generator* generator);

  /// The states of the robots are those of no macrostep of this Move: at its start, after holding.
  void begin() noexcept;
  /// The generator writes the next commands.
  bool due() const noexcept { return due_; }
  /// Whether it can bring the robots to rest on their paths. A robot that executes a force command has none.
  bool can_halt() const noexcept;
  /// Whether the commands under way are stretched; else they were left as the generator wrote them.
  bool stretches() const noexcept { return stretches_; }
  /// Whether the motion is executed otherwise than the generator commands it.
  bool acts() const noexcept { return scales_ && !(due_ && place_ == 0 && scale_.is_real_time()); }
  /// Stretches the commands to `wanted`, 0..1; 0 brings the robots to rest on their paths.
  void write(double wanted) noexcept;
  TimeScale scale() const noexcept { return scale_; }

  /// While it exists, the states of the robots are those that the generator has commanded.
  class OwnTime {
   public:
    explicit OwnTime(SpeedOverride& speed) noexcept;
    ~OwnTime();
    OwnTime(const OwnTime&) = delete;
    OwnTime& operator=(const OwnTime&) = delete;

   private:
    SpeedOverride* speed_;
  };

 private:
  struct Piece {
    std::uint16_t ticks = 1;
    double place = 0;  ///< own ticks since the start of the macrostep, at its end
    TimeScale end;
    bool completes = false;  ///< the macrostep
  };

  void take() noexcept;
  bool at_rest() const noexcept;
  /// The piece that is allowed by the limits and comes closest to the wanted speed.
  Piece choose(double wanted) noexcept;
  /// The piece whose scale at its end is `scale_after(duration)`.
  template <class ScaleAfter>
  Piece piece(bool changes, ScaleAfter scale_after) const noexcept;
  RampBounds halt_bounds() const noexcept;
  double load(const Piece& piece) noexcept;
  /// The own time, s, of this macrostep at the piece's end: a robot that rests at its end is exactly there.
  double end_of(const OwnMacrostep& macrostep, const Piece& piece) const noexcept;
  void remember() noexcept;

  const std::vector<Robot*>* robots_;
  std::vector<OwnMacrostep> macrosteps_;
  bool scales_ = false;
  double period_ = 0;
  TimeScale scale_;
  bool due_ = true;
  bool stretches_ = false;  ///< the present macrostep
  bool rests_ = false;      ///< at its end, all robots
  bool short_ = false;      ///< pieces
  bool first_ = true;       ///< its first piece
  double steps_ = 0;        ///< of it, own ticks
  double place_ = 0;        ///< at the end of what has been commanded; when due: since its end, above -1 / s
};

}  // namespace mrroc
