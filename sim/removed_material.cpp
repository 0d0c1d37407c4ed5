#include "sim/removed_material.hpp"

#include <cerrno>
#include <cstring>
#include <iomanip>
#include <string>

#include "config/table.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::sim {

namespace {

constexpr const char* kRecordTitle = "mrroc removed material 1";
constexpr const char* kRecordFile = "removed.txt";

}  // namespace

RemovedMaterial::RemovedMaterial(const std::filesystem::path& folder) : file_(folder / kRecordFile) {}

void RemovedMaterial::write(const World& world, Tick tick) {
  if (!world.milling() || !world.milling()->removed_at()) return;
  errno = 0;
  if (!out_.is_open()) {
    out_.open(file_);
    out_.imbue(std::locale::classic());
    out_ << std::setprecision(9) << kRecordTitle << '\n';
  }
  const Eigen::Vector3d& centre = *world.milling()->removed_at();
  // whole lines: a picture may be drawn during the run
  out_ << tick << ' ' << centre.x() << ' ' << centre.y() << ' ' << centre.z() << std::endl;
  if (!out_)
    throw SystemError(ErrorCode::resources,
                      "cannot write " + file_.string() + ": " + std::strerror(errno != 0 ? errno : EIO));
}

void remove_material(mjModel& model, const std::filesystem::path& scene, const std::filesystem::path& state,
                     Tick tick) {
  const auto milling = Milling::find(model, scene);
  const std::filesystem::path file = state.parent_path() / kRecordFile;
  if (state.empty() || !std::filesystem::exists(file)) return;
  if (!milling) throw config::ConfigurationError(file, 1, "", "removed material", "a world with a cutter");
  std::ifstream in(file);
  in.imbue(std::locale::classic());
  std::string title;
  std::getline(in, title);
  if (title != kRecordTitle)
    throw config::ConfigurationError(file, 1, "", "not a record of removed material",
                                     std::string("\"") + kRecordTitle + "\"");
  int line = 1;
  for (std::string text; std::getline(in, text);) {
    ++line;
    if (in.eof()) break;  // the line that the run is writing
    std::istringstream words(text);
    words.imbue(std::locale::classic());
    Tick at = 0;
    Eigen::Vector3d centre;
    if (!(words >> at >> centre.x() >> centre.y() >> centre.z()) || !centre.allFinite())
      throw config::ConfigurationError(file, line, "", "unreadable", "a tick and three numbers");
    if (at > tick) break;
    milling->carve(model, centre);
  }
}

}  // namespace mrroc::sim
