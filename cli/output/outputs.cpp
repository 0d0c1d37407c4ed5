#include "cli/output/outputs.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "cli/hosts/agent_protocol.hpp"
#include "command/replaceable.hpp"
#include "recording/recording_reader.hpp"

namespace mrroc::cli {

namespace {

/// What the files of a run begin with.
constexpr std::string_view kMotion = "# limits ", kNotes = "[[events]]";

}  // namespace

process::ClaimedFile claim_live(const std::filesystem::path& path, const std::string& option, const std::string& what) {
  struct stat status {};
  // it is written between two steps of the world: a stopped reader would stop the world
  if (::stat(path.c_str(), &status) == 0 && (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode)))
    throw std::runtime_error(option + " " + path.string() + ": is a pipe, expected a file");
  return {path, what};
}

Outputs::Outputs(const RunOptions& options, const config::Deployment& deployment, const RecordingOutput::Wait& wait) {
  for (const auto& [key, file] : input_files(deployment)) known_.emplace_back(key, process::identity_of(file));
  if (!options.events.empty()) known_.emplace_back("--events", process::identity_of(options.events));
  const bool remote = deployment.sim && !deployment.sim->host.empty();
  if (!options.motion.empty() && !remote) {
    check_apart("--motion", options.motion);
    known_.emplace_back("--motion",
                        motion_.emplace(claim_live(options.motion, "--motion", "the motion file")).identity());
    check_replaceable("--motion", options.motion, kMotion, "a motion file");
  }
  if (!options.note_events.empty()) {
    check_apart("--note-events", options.note_events);
    notes_.emplace(claim_live(options.note_events, "--note-events", "the noted events"));
    check_replaceable("--note-events", options.note_events, kNotes, "noted events");
    known_.emplace_back("--note-events", notes_->identity());
  }
  if (!options.recording.empty()) {
    check_apart("--record", options.recording);
    record_last_ = options.record_last.has_value();
    recording_.emplace(options.recording, deployment.start_timeout, wait);
    check_replaceable("--record", options.recording, recording::kBeginning, "a recording");
    if (!recording_->opened()) return;
    known_.emplace_back("--record", recording_->identity());
  }
  if (!options.snapshots.empty()) {
    std::filesystem::create_directories(options.snapshots);
    snapshots_.emplace(process::ClaimedFile::folder(options.snapshots, "the snapshots"));
    if (access(options.snapshots.c_str(), W_OK | X_OK) != 0)
      throw std::runtime_error("cannot write the snapshots " + options.snapshots.string() + ": " +
                               std::strerror(errno));
  }
  if (!options.black_box.empty()) check_apart("--black-box", options.black_box);
}

void Outputs::check_replaceable(const std::string& option, const std::filesystem::path& path,
                                std::string_view beginning, const std::string& kind) {
  if (process::named_descriptor(path) < 0) command::check_replaceable(path, beginning, option, kind);
}

void Outputs::check_apart(const std::string& option, const std::filesystem::path& path) const {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || S_ISCHR(status.st_mode)) return;
  const process::FileIdentity own = process::identity_of(path);
  const auto same = [&own](const auto& entry) { return entry.second == own; };
  const auto other = std::find_if(known_.begin(), known_.end(), same);
  if (other == known_.end()) return;
  throw std::runtime_error(option + " " + path.string() + ": is also the file of " + other->first +
                           ", expected another file");
}

void Outputs::begin() {
  if (motion_ && motion_->is_own_regular_file() && ftruncate(motion_->fd(), 0) != 0)
    throw std::runtime_error("cannot write the motion file " + motion_->path().string() + ": " + std::strerror(errno));
  // one of the last seconds replaces the file only when there is something to write
  if (recording_ && !record_last_) recording_->clear();
  if (notes_ && notes_->is_own_regular_file() && ftruncate(notes_->fd(), 0) != 0)
    throw std::runtime_error("cannot write the noted events " + notes_->path().string() + ": " + std::strerror(errno));
}

void Outputs::pass_on_recording(const RecordingOutput::Continue& go_on) {
  if (recording_ && recording_->opened()) recording_->pass_on(go_on);
}

}  // namespace mrroc::cli
