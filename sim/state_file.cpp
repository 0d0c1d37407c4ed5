#include "sim/state_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <string>

#include "config/table.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::sim {

namespace {

constexpr const char* kTitle = "mrroc world state 1";
constexpr std::size_t kMaxPositions = 1000000;

}  // namespace

void save_state(const std::filesystem::path& file, const WorldState& state) {
  std::filesystem::path unfinished = file;
  unfinished += ".part";
  {
    errno = 0;
    std::ofstream out(unfinished);
    out.imbue(std::locale::classic());
    out << std::setprecision(17) << kTitle << '\n'
        << state.tick << ' ' << state.time << ' ' << state.positions.size() << '\n';
    for (const double value : state.positions) out << value << '\n';
    out.close();
    if (!out) {
      const std::string reason = std::strerror(errno != 0 ? errno : EIO);
      std::error_code ignored;
      std::filesystem::remove(unfinished, ignored);
      throw SystemError(ErrorCode::resources, "cannot write " + unfinished.string() + ": " + reason);
    }
  }
  std::error_code error;
  std::filesystem::rename(unfinished, file, error);
  if (error) throw SystemError(ErrorCode::resources, "cannot write " + file.string() + ": " + error.message());
}

WorldState load_state(const std::filesystem::path& file) {
  std::ifstream in(file);
  in.imbue(std::locale::classic());
  std::string title;
  WorldState state;
  std::size_t count = 0;
  std::getline(in, title);
  if (title != kTitle)
    throw config::ConfigurationError(file, 1, "", "not a world state", std::string("\"") + kTitle + "\"");
  in >> state.tick >> state.time >> count;
  if (!in || count > kMaxPositions) {
    throw config::ConfigurationError(file, 2, "", "unreadable", "tick, time and the number of positions");
  }
  state.positions.resize(count);
  for (double& value : state.positions) in >> value;
  if (!in) throw config::ConfigurationError(file, 0, "", "cut short", std::to_string(count) + " positions");
  return state;
}

}  // namespace mrroc::sim
