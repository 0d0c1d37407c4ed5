#include "cli/commands/plot_command.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/record/plot.hpp"
#include "cli/record/signals.hpp"
#include "command/number_option.hpp"
#include "command/print.hpp"
#include "command/write_file.hpp"
#include "config/table.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::cli {

namespace {

constexpr double kLongest = 1e9;     // s
constexpr double kGreatest = 1e300;  // of a level

struct PlotArguments {
  std::filesystem::path file, picture;
  std::vector<std::string> names;
  record::TimeSpan span;
  std::optional<double> level;
};

/// The extremes of a signal with their times, and the time at which it first has `level`.
std::string row(const record::Signal& signal, const std::optional<double>& level) {
  const auto [least, greatest] = std::minmax_element(signal.values.begin(), signal.values.end());
  const auto time_of = [&](auto place) {
    return signal.times[static_cast<std::size_t>(place - signal.values.begin())];
  };
  std::string text = fmt::format("{:<40} {:>8} {:>12.6g} at {:>8.3f} s {:>12.6g} at {:>8.3f} s", signal.name,
                                 signal.values.size(), *least, time_of(least), *greatest, time_of(greatest));
  if (level) {
    // from below or from above
    const bool below = signal.values.front() < *level;
    const auto reached = std::find_if(signal.values.begin(), signal.values.end(),
                                      [&](double value) { return below ? value >= *level : value <= *level; });
    text += reached == signal.values.end() ? fmt::format("  never {:g}", *level)
                                           : fmt::format("  {:g} at {:.3f} s", *level, time_of(reached));
  }
  return text + "\n";
}

void plot(const PlotArguments& arguments) {
  if (!arguments.picture.empty() && arguments.picture.extension() != ".svg")
    throw config::ConfigurationError(arguments.file, 0, "--output",
                                     config::in_quotes(arguments.picture.string()) + " is no name of a picture",
                                     "a name that ends with .svg");
  if (arguments.span.from > arguments.span.to)
    throw config::ConfigurationError(arguments.file, 0, "--from", "is after --to", "a time before it");
  const auto groups = record::read_signals(arguments.file, arguments.names, arguments.span);
  std::string table = fmt::format("{:<40} {:>8} {:>26} {:>26}\n", "signal", "messages", "least", "greatest");
  for (const std::vector<record::Signal>& group : groups)
    for (const record::Signal& signal : group) table += row(signal, arguments.level);
  const std::string svg = record::draw(groups);
  const std::filesystem::path picture =
      arguments.picture.empty() ? std::filesystem::path(arguments.file).replace_extension(".svg") : arguments.picture;
  std::error_code none;
  if (std::filesystem::equivalent(picture, arguments.file, none))
    throw config::ConfigurationError(arguments.file, 0, "--output", "it is the recording itself",
                                     "another file for the picture");
  command::write_file(picture, std::as_bytes(std::span(svg)));
  command::print(table + "picture: " + picture.string() + "\n");
}

}  // namespace

void add_plot_command(CLI::App& trace, int& exit_code) {
  auto arguments = std::make_shared<PlotArguments>();
  CLI::App* command = trace.add_subcommand(
      "plot", "Draw signals of a recording, and print their extremes; without a signal, list the names");
  command->add_option("FILE", arguments->file, "Recording (MCAP)")->required();
  command->add_option("SIGNAL", arguments->names, "TOPIC/FIELD or TOPIC/FIELD[INDEX], such as /arm/servo/current[0]");
  command->add_option("-o,--output", arguments->picture, "Picture (SVG); without it beside the recording, as .svg");
  command::add_number(*command, "--from", arguments->span.from, 0.0, kLongest,
                      "First time of the run that is drawn, s");
  command::add_number(*command, "--to", arguments->span.to, 0.0, kLongest, "Last time of the run that is drawn, s");
  command::add_number(*command, "--level", arguments->level, -kGreatest, kGreatest,
                      "Print when each signal first reaches this value");
  command->callback([arguments, &exit_code] {
    exit_code = 0;
    if (!arguments->names.empty()) return plot(*arguments);
    for (const std::string& name : record::signal_names(arguments->file)) command::print(name + "\n");
  });
}

}  // namespace mrroc::cli
