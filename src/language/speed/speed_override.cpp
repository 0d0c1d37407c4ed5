#include "language/speed/speed_override.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kSameOwnTick = 1e-6;  // own ticks
constexpr int kShortPiece = 25;        // ticks: for changes of the speed, and paths that are not of the joints
constexpr double kFullLoad = 0.95;     // of the limits, by a change of the speed
constexpr RampBounds kChange{1, 4};    // of the operator's changes: not felt as a jolt
constexpr RampBounds kHalt{20, 400};   // of a halt, at most
constexpr double kFirmness[] = {1, 0.6, 0.36, 0.22, 0.13, 0.08, 0.05, 0.03};  // of the bounds
constexpr double kCoasting[] = {1, 0.5, 0};                                   // of the present rate

using Kind = OwnMacrostep::Kind;

}  // namespace

SpeedOverride::SpeedOverride(const std::vector<Robot*>& robots, const Generator* generator)
    : robots_(&robots), scales_(generator != nullptr && !robots.empty() && generator->scales_with_speed()) {
  if (!scales_) return;
  period_ = robots.front()->task().servo_period();
  macrosteps_.reserve(robots.size());
  for (Robot* robot : robots) macrosteps_.emplace_back(*robot);
}

bool SpeedOverride::at_rest() const noexcept {
  return std::all_of(macrosteps_.begin(), macrosteps_.end(),
                     [](const OwnMacrostep& macrostep) { return macrostep.robot().state().at_rest(); });
}

bool SpeedOverride::can_halt() const noexcept {
  return scales_ && std::none_of(robots_->begin(), robots_->end(),
                                 [](const Robot* robot) { return robot->command().kind == CommandKind::force; });
}

void SpeedOverride::begin() noexcept {
  if (!scales_)
    for (Robot* robot : *robots_) robot->time_scale() = TimeScale{};
  due_ = true;
  place_ = 0;
  scale_ = TimeScale{};
  const TimeScale* fastest = nullptr;  // of the robots in motion: their desired velocities stay within the limits
  for (OwnMacrostep& macrostep : macrosteps_) {
    macrostep.forget();
    const TimeScale& scale = macrostep.robot().time_scale();
    if (macrostep.robot().state().at_rest()) continue;
    if (fastest == nullptr || scale.factor > fastest->factor) fastest = &scale;
  }
  if (fastest != nullptr && fastest->factor > 0) scale_ = *fastest;
}

void SpeedOverride::write(double wanted) noexcept {
  if (!scales_) return;
  if (due_) {
    if (at_rest() && wanted > 0) {
      scale_ = {wanted, 0};
      place_ = 0;
    }
    if (wanted == 1 && !acts()) {
      for (OwnMacrostep& macrostep : macrosteps_) macrostep.forget();
      return remember();
    }
    take();
    if (!stretches_) return remember();
  }
  const Piece next = choose(wanted);
  for (OwnMacrostep& macrostep : macrosteps_) macrostep.command(end_of(macrostep, next), next.end, next.ticks, first_);
  scale_ = next.end;
  place_ = next.place;
  due_ = next.completes;
  first_ = false;
  if (due_) place_ -= steps_;
  remember();
}

void SpeedOverride::take() noexcept {
  for (OwnMacrostep& macrostep : macrosteps_) macrostep.take(scale_);
  const auto is = [this](Kind kind) {
    return std::any_of(macrosteps_.begin(), macrosteps_.end(),
                       [kind](const OwnMacrostep& macrostep) { return macrostep.kind() == kind; });
  };
  stretches_ = (is(Kind::path) || is(Kind::velocity)) && !is(Kind::refused);
  rests_ = !is(Kind::velocity);
  short_ = false;
  steps_ = 0;
  for (const OwnMacrostep& macrostep : macrosteps_) {
    const bool moves = macrostep.kind() == Kind::path || macrostep.kind() == Kind::velocity;
    if (moves) steps_ = std::max(steps_, static_cast<double>(macrostep.steps()));
    if (macrostep.kind() == Kind::path && !macrostep.ends_at_rest()) rests_ = false;
    if (macrostep.needs_short_pieces()) short_ = true;
  }
  // a robot whose shorter macrostep ends in motion would be late: that is left to the EDP
  for (const OwnMacrostep& macrostep : macrosteps_)
    if (macrostep.kind() == Kind::path && !macrostep.ends_at_rest() && macrostep.steps() != steps_) stretches_ = false;
  first_ = true;
  if (stretches_) return;
  place_ = 0;
  scale_ = TimeScale{};
}

template <class ScaleAfter>
SpeedOverride::Piece SpeedOverride::piece(bool changes, ScaleAfter scale_after) const noexcept {
  const auto longest =
      std::max(1, static_cast<int>(changes || short_ ? std::min<double>(steps_, kShortPiece) : steps_));
  const auto of = [&](int ticks) {
    Piece piece;
    piece.ticks = static_cast<std::uint16_t>(ticks);
    piece.end = scale_after(ticks * period_);
    piece.place = place_ + own_time(scale_, piece.end, ticks * period_) / period_;
    return piece;
  };
  const auto reaches_end = [this](const Piece& piece) { return piece.place >= steps_ - kSameOwnTick; };
  Piece next = of(longest);
  if (reaches_end(next)) {
    while (next.ticks > 1 && reaches_end(of(next.ticks - 1))) next = of(next.ticks - 1);
  } else if (steps_ - next.place < (0.5 * longest + 1) * next.end.factor) {
    // too little would remain for another piece
    while (next.ticks < 2 * (longest + 1) && !reaches_end(next)) next = of(next.ticks + 1);
  }
  if (!reaches_end(next)) return next;
  next.completes = true;
  if (rests_ || next.place <= steps_ + kSameOwnTick) {
    next.place = steps_;
  } else if (next.ticks > 1) {
    next = of(next.ticks - 1);
    next.completes = true;
  }
  return next;
}

SpeedOverride::Piece SpeedOverride::choose(double wanted) noexcept {
  if (scale_.factor == wanted && scale_.rate == 0) return piece(false, [this](double) { return scale_; });
  Piece best;
  double least = std::numeric_limits<double>::infinity();
  const auto accepts = [&](const Piece& next) {
    const double part = load(next);
    if (part < least) {
      least = part;
      best = next;
    }
    return part <= kFullLoad;
  };
  const RampBounds bounds = wanted == 0 ? halt_bounds() : kChange;
  for (const double firmness : kFirmness) {
    const Piece next = piece(true, [&](double duration) { return ramp(scale_, wanted, duration, bounds, firmness); });
    if (accepts(next)) return next;
  }
  for (const double part : kCoasting) {
    const double rate = part * scale_.rate;
    const Piece next = piece(true, [&](double duration) { return ramp_at_rate(scale_, duration, rate); });
    if (accepts(next)) return next;
  }
  return best;
}

RampBounds SpeedOverride::halt_bounds() const noexcept {
  RampBounds bounds = kHalt;
  for (const OwnMacrostep& macrostep : macrosteps_) {
    const RampBounds own = macrostep.halt_bounds(scale_);
    bounds = {std::min(bounds.rate, own.rate), std::min(bounds.change, own.change)};
  }
  return bounds;
}

double SpeedOverride::load(const Piece& piece) noexcept {
  double largest = 0;
  for (OwnMacrostep& macrostep : macrosteps_)
    largest = std::max(largest, macrostep.load(end_of(macrostep, piece), piece.end, piece.ticks));
  return largest;
}

double SpeedOverride::end_of(const OwnMacrostep& macrostep, const Piece& piece) const noexcept {
  return period_ * (piece.completes && macrostep.ends_at_rest() ? steps_ : piece.place);
}

void SpeedOverride::remember() noexcept {
  for (OwnMacrostep& macrostep : macrosteps_) macrostep.remember(scale_);
}

SpeedOverride::OwnTime::OwnTime(SpeedOverride& speed) noexcept : speed_(speed.acts() ? &speed : nullptr) {
  if (speed_ == nullptr) return;
  for (OwnMacrostep& macrostep : speed_->macrosteps_) macrostep.show(speed_->scale_);
}

SpeedOverride::OwnTime::~OwnTime() {
  if (speed_ == nullptr) return;
  for (OwnMacrostep& macrostep : speed_->macrosteps_) macrostep.hide();
}

}  // namespace mrroc
