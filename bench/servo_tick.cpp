// What a recorded tick costs the servo's thread (`--record-rate servo`): ticks of an IRb-6's servo with and without a
// tap, in turn, round by round, in processor time of this thread. Exit code 1 when the medians differ by more than 1
// us.
#include <time.h>

#include <cstdint>
#include <cstdio>
#include <vector>

#include "drivers/loopback/loopback_hardware.hpp"
#include "edp/command/effector.hpp"
#include "edp/servo/servo.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "round_times.hpp"

namespace {

using namespace mrroc;

constexpr double kPeriod = 0.002;  // s
constexpr int kRounds = 201;
constexpr int kTicks = 500;  // of a round
constexpr double kBar = 1;   // us

std::int64_t now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return time.tv_sec * 1'000'000'000L + time.tv_nsec;
}

class Robot {
 public:
  Robot() { effector_.enable(true); }

  void use(edp::ServoTap& tap) { servo_.use_tap(tap, false); }

  void measure(RoundTimes& times) {
    std::vector<std::int64_t> stamps{now()};
    stamps.reserve(kTicks + 1);
    for (int tick = 0; tick < kTicks; ++tick) {
      servo_.tick(tick_++);
      stamps.push_back(now());
    }
    while (effector_.poll(reply_)) {
    }
    times.add(stamps);
  }

 private:
  RobotModels models_ = load_irb6(MRROC_SOURCE_DIR "/robots/irb6/irb6.toml");
  edp::ModelSet model_set_{models_};
  edp::LoopbackHardware hardware_{*models_.front(), kPeriod};
  edp::ServoChannel channel_;
  edp::Servo servo_{model_set_, hardware_, kPeriod, channel_};
  edp::Effector effector_{model_set_, kPeriod, channel_};
  edp::Reply reply_;
  Tick tick_ = 0;
};

}  // namespace

int main() {
  Robot plain, recorded;
  edp::ServoTap reader = edp::ServoTap::create(edp::kServoTapName, edp::kServoTapWhat);
  edp::ServoTap tap = edp::ServoTap::attach(reader.fd(), edp::kServoTapWhat);
  recorded.use(tap);
  RoundTimes without, with;
  for (int round = 0; round < kRounds; ++round) {
    plain.measure(without);
    recorded.measure(with);
    for (; reader.front() != nullptr; reader.pop()) {
    }
  }
  const double base = quantile(without.p50, 0.5), cost = quantile(with.p50, 0.5) - base;
  std::printf("servo tick of 6 axes, us: p50 %.2f, recorded %.2f (x %.2f); p99 %.2f, recorded %.2f; dropped %llu\n",
              base, base + cost, median_ratio(with.p50, without.p50), quantile(without.p99, 0.5),
              quantile(with.p99, 0.5), static_cast<unsigned long long>(reader.dropped()));
  std::printf("a recorded tick costs %.2f us (bar %.0f)\n", cost, kBar);
  return cost <= kBar && reader.dropped() == 0 ? 0 : 1;
}
