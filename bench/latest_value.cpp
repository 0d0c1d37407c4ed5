// Cost of reading a non-interactive sensor: Sensor::collect_reading() on a real link, while the VSP's end publishes a
// thousand readings a second. Measured in turn, round by round, against a plain copy of a reading; the figures are
// medians over the rounds. The reading thread must not allocate.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "clock/wall/monotonic.hpp"
#include "links/exchange/sensor_requester.hpp"
#include "links/exchange/sensor_responder.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "mrroc/errors.hpp"
#include "mrroc/sensor.hpp"
#include "mrroc/task.hpp"
#include "round_times.hpp"

namespace {

thread_local long allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace mrroc {
namespace {

constexpr int kRounds = 500;
constexpr int kReads = 2000;  // per round
constexpr double kBar = 200;  // ns

/// A task with one non-interactive sensor.
class ReadingTask : public Task {
 public:
  explicit ReadingTask(SensorLink& link) : link_(link) {}
  const std::string& process_name() const noexcept override { return name_; }
  std::string robot_name(const std::string& requested) const override { return requested; }
  RobotLink& robot_link(const std::string& name, const std::string&) override {
    throw NonFatalError(ErrorCode::invalid_argument, name);
  }
  SensorLink& sensor_link(const std::string&, const std::string&, bool& interactive) override {
    interactive = false;
    return link_;
  }
  double servo_period() const noexcept override { return 0.002; }
  Tick tick() const noexcept override { return 0; }
  double wall_seconds() const noexcept override { return 0; }
  void sleep_until(Tick) override {}
  OperatorRequest operator_request() noexcept override { return OperatorRequest::none; }
  bool take_trigger() noexcept override { return false; }
  StepObserver* observer() noexcept override { return nullptr; }

 private:
  SensorLink& link_;
  std::string name_ = "reader";
};

/// ns per call of `read` in one round.
template <class Read>
double time_of(Read read) {
  const std::int64_t begin = clock::monotonic_ns();
  for (int i = 0; i < kReads; ++i) read();
  return static_cast<double>(clock::monotonic_ns() - begin) / kReads;
}

int measure() {
  links::TestDomain net;
  links::TestClock clock;
  links::SensorResponder vsp(net.domain, clock, "bench/gate", {"reader"}, true);
  links::SensorRequester link(net.domain, clock, "bench/gate", "reader", "gate", {.published = true});
  link.connect(links::kPatience);
  ReadingTask task(link);
  Sensor gate(task, "gate", "any");

  std::atomic<bool> end{false};
  std::thread publisher([&] {
    SensorReading reading;
    reading.channel_count = 2;
    while (!end) {
      ++reading.sequence;
      vsp.publish(reading);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  while (gate.reading().sequence == 0) gate.collect_reading();
  const std::uint64_t first = gate.reading().sequence;

  std::vector<double> reads, copies;
  SensorReading from, to;
  reads.reserve(kRounds);
  copies.reserve(kRounds);
  const long before = allocations;
  for (int round = 0; round < kRounds; ++round) {
    reads.push_back(time_of([&] { gate.collect_reading(); }));
    copies.push_back(time_of([&] {
      to = from;
      asm volatile("" : : "r"(&to) : "memory");  // the copy is made
    }));
  }
  const long allocated = allocations - before;
  end = true;
  publisher.join();

  const double read = quantile(reads, 0.5);
  std::printf("latest value: %.0f ns (bar %.0f), p99 of the rounds %.0f ns; a copy of a reading: %.0f ns, ratio %.2f\n",
              read, kBar, quantile(reads, 0.99), quantile(copies, 0.5), median_ratio(reads, copies));
  std::printf("%llu new readings meanwhile, %ld allocations\n",
              static_cast<unsigned long long>(gate.reading().sequence - first), allocated);
  return read <= kBar && allocated == 0 && gate.reading().sequence > first ? 0 : 1;
}

}  // namespace
}  // namespace mrroc

int main() { return mrroc::measure(); }
