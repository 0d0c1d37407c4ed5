// Cost of a robot's kinematics, ns per call, compared with KDL's for the chain of the same URDF.
//   kinematics [--rounds n] [--postures n] [--near rad] [--seed n]
//
// Every robot of robots/: direct, inverse and Jacobian of the tool frame, each over the same random postures for both.
// The inverse starts with every joint off by `near`. KDL's inverse is Levenberg-Marquardt (LMA); its Newton-Raphson is
// listed below for reference. The answers are compared before the measurement. A round measures both in turn, in
// processor time of this thread, so that other work of the machine does not count. The table shows medians over the
// rounds, of times and of ratios (KDL / mrroc). Where the URDF has no plain chain of the robot's axes to the tool, KDL
// is omitted and the reason is printed; else the generic chain of the same URDF, as the stock type for arms has it, is
// measured, too, and compared with the robot's own model.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string_view>
#include <vector>

#include "bench/kinematics/chain_twin.hpp"
#include "bench/kinematics/contest.hpp"
#include "bench/kinematics/robots.hpp"
#include "bench/round_times.hpp"

namespace mrroc::bench {
namespace {

constexpr std::string_view kJudged = "irb6";  // its inverse against LMA
constexpr double kBar = 50;
constexpr double kGoal = 100;
constexpr double kTwice = 2;

void print_row(const Contest& contest, const char* function, const FunctionTimes& times) {
  std::printf("%-20s %-9s %9.0f", contest.robot().c_str(), function, quantile(times.own, 0.5));
  if (times.kdl.empty()) {
    std::printf("        -        -\n");
  } else {
    std::printf(" %8.0f %8.1f\n", quantile(times.kdl, 0.5), median_ratio(times.kdl, times.own));
  }
}

void print_remarks(const Contest& contest) {
  if (!contest.without_kdl().empty())
    std::printf("  without KDL, the URDF is not a chain of the axes: %s\n", contest.without_kdl().c_str());
  const auto [own, lma, newton] = contest.refused();
  if (own + lma + newton > 0) {
    std::printf("  postures drawn again because an inverse did not find them: mrroc %d, LMA %d, Newton %d\n", own, lma,
                newton);
  }
}

/// Direct kinematics and Jacobian of the generic chain may take kTwice the time of the robot's own, of several axes;
/// false: they take longer.
bool print_twin(const Contest& own, Contest& twin, int rounds) {
  for (int round = 0; round < rounds; ++round) twin.run_round(round % 2 == 0);
  const bool arm = own.parameters().axes.size() > 1;
  bool pass = true;
  const auto print = [&](const char* function, const FunctionTimes& times, const FunctionTimes& written, bool judged) {
    const double ratio = quantile(times.own, 0.5) / quantile(written.own, 0.5);
    pass = pass && (!judged || !arm || ratio <= kTwice);
    std::printf("%-20s %-9s %9.0f %8.0f %8.1f   %.2f of the time of its own\n", "  as a chain", function,
                quantile(times.own, 0.5), quantile(times.kdl, 0.5), median_ratio(times.kdl, times.own), ratio);
  };
  print("direct", twin.direct, own.direct, true);
  print("inverse", twin.inverse, own.inverse, false);
  print("Jacobian", twin.jacobian, own.jacobian, true);
  return pass;
}

int run(const Contest::Options& options, int rounds) {
  std::vector<std::unique_ptr<Contest>> contests;
  for (const RobotModels& models : load_robots()) contests.push_back(std::make_unique<Contest>(models, options));

  std::printf("robot                function  mrroc, ns  KDL, ns    ratio\n");
  double judged = 0;
  bool twins = true;
  for (const auto& contest : contests) {
    for (int round = 0; round < rounds; ++round) contest->run_round(round % 2 == 0);
    print_row(*contest, "direct", contest->direct);
    print_row(*contest, "inverse", contest->inverse);
    if (!contest->newton.empty()) print_row(*contest, "  Newton", {contest->inverse.own, contest->newton});
    print_row(*contest, "Jacobian", contest->jacobian);
    print_remarks(*contest);
    if (contest->without_kdl().empty()) {
      Contest twin(chain_twin(contest->parameters()), options);
      twins = print_twin(*contest, twin, rounds) && twins;
    }
    if (contest->robot() == kJudged && contest->without_kdl().empty())
      judged = median_ratio(contest->inverse.kdl, contest->inverse.own);
  }
  const bool pass = judged >= kBar;
  std::printf("inverse of %s, LMA / mrroc: %.0f; bar %.0f: %s; goal %.0f: %s\n", kJudged.data(), judged, kBar,
              pass ? "pass" : "FAIL", kGoal, judged >= kGoal ? "pass" : "FAIL");
  std::printf("direct kinematics and Jacobian of chains at most %.0f times as long: %s\n", kTwice,
              twins ? "pass" : "FAIL");
  return pass && twins ? 0 : 1;
}

}  // namespace
}  // namespace mrroc::bench

int main(int argc, char** argv) {
  mrroc::bench::Contest::Options options;
  int rounds = 41;
  CLI::App app{"Direct and inverse kinematics and Jacobian of every robot beside KDL's"};
  app.add_option("--rounds", rounds, "how often everything is measured")->check(CLI::PositiveNumber);
  app.add_option("--postures", options.postures, "per robot and round")->check(CLI::PositiveNumber);
  app.add_option("--near", options.off, "rad or m by which every joint is off where the inverse starts");
  app.add_option("--seed", options.seed, "of the postures");
  CLI11_PARSE(app, argc, argv);
  try {
    return mrroc::bench::run(options, rounds);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
