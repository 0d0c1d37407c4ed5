#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "command/number_option.hpp"
#include "command/parse_command.hpp"
#include "testing/driver/checks.hpp"

namespace mrroc::driver_test {

namespace {

std::vector<Check> all_checks() {
  std::vector<Check> all;
  for (const auto part : {start_checks(), power_checks(), trouble_checks(), real_time_checks(), clock_checks()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

enum class Verdict { passed, failed, not_made };

/// Makes one check with a driver of its own, and prints its line.
Verdict make(const Subject& subject, std::size_t number, const Check& check) {
  Verdict verdict = Verdict::passed;
  std::string reason;
  try {
    Bench bench(subject);
    check.make(bench);
  } catch (const NotMade& problem) {
    verdict = Verdict::not_made;
    reason = problem.what();
  } catch (const std::exception& problem) {
    verdict = Verdict::failed;
    reason = problem.what();
  }
  static constexpr std::array kWords{"passed", "FAILED", "not made"};
  std::printf("%2zu %-18s %-8s %s\n", number, check.name, kWords[static_cast<std::size_t>(verdict)],
              reason.empty() ? check.says : reason.c_str());
  std::fflush(stdout);
  return verdict;
}

}  // namespace

int run(int argc, char** argv, StandIn& stand_in, const edp::ModelFactory& load_models) {
  CLI::App app{"Conformance test of a driver"};
  std::string driver, type;
  std::filesystem::path parameters;
  std::size_t only = 0;
  app.add_option("driver", driver)->required();
  app.add_option("type", type, "of the robot")->required();
  app.add_option("parameters", parameters, "of the robot; the type's own when left out");
  // beside the folder of the test: the EDP of the robot
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  ::setenv("MRROC_PROGRAMS", (here.parent_path() / "bin").c_str(), 0);
  const std::vector<Check> checks = all_checks();
  command::add_number<std::size_t>(app, "--only", only, 1, checks.size(), "the number of the only check");
  CLI11_PARSE(app, argc, argv);
  if (!parameters.empty()) parameters = std::filesystem::absolute(parameters);
  const Subject subject{driver, type, parameters, stand_in, load_models(parameters)};
  std::array<int, 3> counts{};
  for (std::size_t i = 0; i < checks.size(); ++i)
    if (only == 0 || only == i + 1) ++counts[static_cast<std::size_t>(make(subject, i + 1, checks[i]))];
  std::printf("driver %s: %d checks passed, %d failed, %d not made\n", driver.c_str(), counts[0], counts[1], counts[2]);
  return counts[1] == 0 && counts[0] > 0 ? 0 : 1;
}

}  // namespace mrroc::driver_test
