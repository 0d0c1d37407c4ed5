// driver_faults SEEDS [NAME]: troubles of a simulated UR controller, of a Net F/T, of the network to them, and of an
// I/O node on a CAN bus, each in SEEDS motions at a random tick; a line of a table for each (those whose names begin
// with NAME). Exit code 1 when a limit was exceeded, an arm did not stop, or it could not be moved again.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string_view>

#include "driver_faults/cell.hpp"
#include "driver_faults/troubles.hpp"

namespace {

using namespace mrroc;
using namespace mrroc::driver_faults;

constexpr double kWay = 0.25;               // rad
constexpr double kSpeedMost = 1.15;         // of the arm: where MotionWatch draws the line
constexpr double kSetMost = 1.001;          // of set-points
constexpr double kAccelerationMost = 1.02;  // of set-points, by differences

/// The runs with one trouble.
struct Row {
  int runs = 0, continued = 0, bad = 0;
  std::map<std::string, int> stops;  ///< number of runs by the error that ended their motion
  std::vector<Tick> latency;         ///< ticks from the trouble until a stopped arm stands
  Worst worst;
};

/// What a run has done wrong: the first of these; null: nothing.
class Verdict {
 public:
  void expect(bool holds, const char* wrong) noexcept {
    if (!holds && wrong_ == nullptr) wrong_ = wrong;
  }
  const char* wrong() const noexcept { return wrong_; }

 private:
  const char* wrong_ = nullptr;
};

void run(const Trouble& trouble, unsigned seed, Row& row) {
  std::mt19937 random(seed);
  Cell cell(trouble.make());
  Verdict verdict;
  verdict.expect(cell.recover(), "the drives are not on before the trouble");
  cell.worst = {};
  cell.start_move(seed % 2 == 0 ? kWay : -kWay);
  cell.ticks(60 + static_cast<int>(random() % 280));
  const Tick begun = cell.now();
  trouble.begin(cell.device());
  cell.ticks(20 + static_cast<int>(random() % 130));
  verdict.expect(cell.settle(), "the motion does not end");
  const ErrorCode error = cell.fault() != ErrorCode::none ? cell.fault() : cell.answer();
  if (error == ErrorCode::none) {
    ++row.continued;
  } else {
    ++row.stops[std::string(describe(error))];
    row.latency.push_back(std::max(cell.moved(), begun) - begun);
  }
  trouble.end(cell.device());
  cell.ticks(100);
  if (cell.fault() != ErrorCode::none) verdict.expect(cell.recover(), "it cannot be recovered after the trouble");
  cell.start_move(0.2 * kWay);
  verdict.expect(cell.settle(), "the motion after the trouble does not end");
  verdict.expect(cell.answer() == ErrorCode::none, "the motion after the trouble ends with an error");
  verdict.expect(cell.worst.speed <= kSpeedMost, "the arm is too fast");
  verdict.expect(cell.worst.set_speed <= kSetMost, "set-points are too fast");
  verdict.expect(cell.worst.set_acceleration <= kAccelerationMost, "set-points accelerate too much");
  ++row.runs;
  if (verdict.wrong() != nullptr) {
    ++row.bad;
    const auto text = [](ErrorCode code) { return std::string(describe(code)); };
    std::fprintf(stderr, "%s, seed %u: %s (fault: %s; answer: %s)\n", trouble.name.c_str(), seed, verdict.wrong(),
                 text(cell.fault()).c_str(), text(cell.answer()).c_str());
  }
  row.worst.speed = std::max(row.worst.speed, cell.worst.speed);
  row.worst.set_speed = std::max(row.worst.set_speed, cell.worst.set_speed);
  row.worst.set_acceleration = std::max(row.worst.set_acceleration, cell.worst.set_acceleration);
}

void print(const std::string& name, Row& row) {
  std::string stops;
  for (const auto& [error, count] : row.stops)
    stops.append(stops.empty() ? "" : ", ").append(std::to_string(count)).append(" x ").append(error);
  std::sort(row.latency.begin(), row.latency.end());
  std::string latency = "-";
  if (!row.latency.empty())
    latency = std::to_string(2 * row.latency[row.latency.size() / 2]) + " / " + std::to_string(2 * row.latency.back());
  std::printf("| %s | %d | %d | %s | %s | %.3f | %.3f | %.3f | %d |\n", name.c_str(), row.runs, row.continued,
              stops.empty() ? "-" : stops.c_str(), latency.c_str(), row.worst.set_speed, row.worst.set_acceleration,
              row.worst.speed, row.bad);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 0;
  if (seeds < 1 || argc > 3) {
    std::fprintf(stderr, "usage: driver_faults SEEDS [NAME]\n");
    return 2;
  }
  const std::string_view wanted = argc > 2 ? argv[2] : "";
  std::printf(
      "| trouble | runs | continued | stopped by | stop p50 / max, ms | set-point speed | acceleration | arm's speed | "
      "bad |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|\n");
  int bad = 0;
  for (const Trouble& trouble : troubles()) {
    if (!trouble.name.starts_with(wanted)) continue;
    Row row;
    for (int seed = 1; seed <= seeds; ++seed) run(trouble, static_cast<unsigned>(seed), row);
    print(trouble.name, row);
    bad += row.bad;
  }
  return bad == 0 ? 0 : 1;
}
