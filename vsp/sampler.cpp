#include "vsp/sampler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "vsp/parameters.hpp"
#include "vsp/reading_error.hpp"

namespace mrroc::vsp {

namespace {

/// Rates are written with few digits: 166.667 Hz is every third tick of 2 ms.
constexpr double kRateTolerance = 1e-4;
constexpr double kMostTicks = 1e9;  ///< between two readings

void check_count(const char* what, std::size_t count, std::size_t most) {
  if (count >= 1 && count <= most) return;
  throw SystemError(ErrorCode::configuration, "a sensor type with " + std::to_string(count) + " " + what +
                                                  ", expected 1 to " + std::to_string(most));
}

}  // namespace

Sampler::Sampler(VirtualSensor& sensor, Source& source, Tick publication_period, bool follows_effector)
    : sensor_(&sensor),
      source_(&source),
      channels_(sensor.channels()),
      raw_channels_(sensor.raw_channels()),
      period_(publication_period),
      follows_(follows_effector) {
  check_count("channels", channels_.size(), kMaxChannels);
  check_count("raw channels", raw_channels_.size(), kMaxRawValues);
  pending_.reserve(kMaxPending);
}

void Sampler::on_request(const Caller& caller, const SensorRequest& request, Tick now, ReadingSink& sink) {
  if (pending_.size() == kMaxPending) {
    SensorReading refused;
    refused.tick = now;
    refused.configuration = configuration_;
    refused.channel_count = static_cast<std::uint32_t>(channels_.size());
    report(refused, ErrorClass::non_fatal, ErrorCode::busy, "%zu requests are waiting for their ticks", kMaxPending);
    sink.reply(caller, refused);
    return;
  }
  const Pending pending{std::max(request.measure_at, now), caller, request.kind, request.configuration};
  const auto later = [](const Pending& a, const Pending& b) { return a.due < b.due; };
  pending_.insert(std::upper_bound(pending_.begin(), pending_.end(), pending, later), pending);
}

void Sampler::on_tick(Tick now, ReadingSink& sink) {
  const bool track = sensor_->continuous() && now >= next_track_;
  const bool publish = period_ != 0 && now >= next_publication_;
  if (!track && !publish && !answer_is_due(now)) return;
  if (waits_for_state(now)) return;
  read_source(now);
  if (sensor_->continuous()) {
    if (raw_usable()) sensor_->track(raw_);
    next_track_ = now + 1;
  }
  answer_due(now, sink);
  if (publish) {
    schedule_publication(now);
    aggregate();
    sink.publish(reading_);
  }
}

/// A reading is due at `now`, and e_l has not come yet.
bool Sampler::waits_for_state(Tick now) noexcept {
  if (!follows_ || (!effector_.empty() && effector_.newest() >= now)) {
    patience_ = 0;
    return false;
  }
  if (patience_ == 0) patience_ = now + kStateLate;
  if (now < patience_) return true;
  patience_ = 0;
  return false;
}

/// Passes the state of r's tick to the sensor.
void Sampler::find_state() noexcept {
  if (!follows_ || !raw_usable()) return;
  const RobotState* state = effector_.at(raw_.tick);
  if (state != nullptr && raw_.tick - state->tick <= kStateAge) return sensor_->effector_state(*state);
  report(raw_fault_, ErrorClass::non_fatal, ErrorCode::sensor_not_ready, "no state of its robot at tick %llu",
         static_cast<unsigned long long>(raw_.tick));
}

void Sampler::read_source(Tick now) noexcept {
  raw_ = RawReading{};
  raw_.tick = now;
  raw_fault_ = SensorReading{};
  fresh_ = false;
  check_raw(source_->read(now, raw_), now);
  find_state();
}

void Sampler::check_raw(SourceState state, Tick now) noexcept {
  const auto fault = [this](const char* format, auto... arguments) {
    report(raw_fault_, ErrorClass::hardware, ErrorCode::sensor_hardware, format, arguments...);
  };
  if (state == SourceState::silent) return fault("silent at tick %llu", static_cast<unsigned long long>(now));
  if (state == SourceState::faulty) {
    const std::string_view why = source_->fault();
    return fault("%.*s", static_cast<int>(why.size()), why.data());
  }
  if (state == SourceState::not_ready) {
    return report(raw_fault_, ErrorClass::non_fatal, ErrorCode::sensor_not_ready,
                  "no hardware reading yet at tick %llu", static_cast<unsigned long long>(now));
  }
  if (raw_.count != raw_channels_.size()) {
    return fault("%u raw values, expected %zu", static_cast<unsigned>(raw_.count), raw_channels_.size());
  }
  for (std::size_t i = 0; i < raw_channels_.size(); ++i) {
    if (!std::isfinite(raw_.values[i])) {
      return fault("raw value %s is %g, expected a finite number", raw_channels_[i].name.c_str(), raw_.values[i]);
    }
  }
  watch_.check(raw_, raw_fault_);
}

void Sampler::answer_due(Tick now, ReadingSink& sink) {
  while (answer_is_due(now)) {
    const Pending pending = pending_.front();
    pending_.erase(pending_.begin());  // before the reply: a sink that throws must not get it twice
    if (pending.kind == SensorRequestKind::configure) {
      sink.reply(pending.caller, answer_to(pending.configuration));
      continue;
    }
    const bool bias = pending.kind == SensorRequestKind::bias;
    if (bias) fresh_ = false;
    const bool bias_refused = bias && raw_usable() && !sensor_->bias(raw_);
    aggregate();
    if (bias_refused) {
      report(reading_, ErrorClass::non_fatal, ErrorCode::invalid_argument, "this type of sensor has no zero to set");
      fresh_ = false;  // the error is for this caller only
    }
    sink.reply(pending.caller, reading_);
  }
}

/// The configuration taken, or the reason why not.
SensorReading Sampler::answer_to(const Message& configuration) noexcept {
  SensorReading answer;
  answer.tick = raw_.tick;
  try {
    sensor_->reconfigure(configuration);
    ++configuration_;
    fresh_ = false;
  } catch (const Error& error) {
    const bool of_system = error.error_class() == ErrorClass::system;  // as at the start: a refusal here
    report(answer, of_system ? ErrorClass::non_fatal : error.error_class(),
           of_system ? ErrorCode::invalid_argument : error.code(), "%s", error.detail().c_str());
  } catch (const std::exception& error) {
    report(answer, ErrorClass::non_fatal, ErrorCode::invalid_argument, "%s", error.what());
  }
  answer.configuration = configuration_;
  return answer;
}

void Sampler::aggregate() noexcept {
  if (fresh_) return;
  fresh_ = true;
  ++reading_.sequence;
  reading_.configuration = configuration_;
  reading_.tick = raw_.tick;
  reading_.channel_count = static_cast<std::uint32_t>(channels_.size());
  reading_.values.fill(std::numeric_limits<double>::quiet_NaN());
  reading_.error = raw_fault_.error;
  if (!raw_usable()) return;
  sensor_->aggregate(raw_, reading_);
  if (reading_.error.error_class != ErrorClass::none) return;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (!std::isfinite(reading_.values[i])) {
      return report(reading_, ErrorClass::non_fatal, ErrorCode::not_finite, "channel %s is %g",
                    channels_[i].name.c_str(), reading_.values[i]);
    }
  }
}

void Sampler::schedule_publication(Tick now) noexcept {
  const Tick passed = (now - next_publication_) / period_;
  missed_ += passed;
  next_publication_ += (passed + 1) * period_;
}

Tick Sampler::next_wake() const noexcept { return patience_ != 0 ? patience_ : next_due(); }

Tick Sampler::next_due() const noexcept {
  Tick wake = pending_.empty() ? kNever : pending_.front().due;
  if (period_ != 0) wake = std::min(wake, next_publication_);
  if (sensor_->continuous()) wake = std::min(wake, next_track_);
  return wake;
}

Tick publication_period(const config::SensorEntry& entry, double servo_period) {
  if (entry.interactive) return 0;
  const double ticks = 1 / (entry.rate * servo_period);
  const double whole = std::round(ticks);
  if (!(whole >= 1) || whole > kMostTicks || std::abs(ticks - whole) > kRateTolerance * ticks) {
    refuse(entry, "rate", std::to_string(entry.rate) + " Hz", "one reading in a whole number of servo periods");
  }
  return static_cast<Tick>(whole);
}

}  // namespace mrroc::vsp
