#include "cli/processes/camera_memories.hpp"

#include <unistd.h>

namespace mrroc::cli {

CameraMemories::CameraMemories(const config::Deployment& deployment, const std::vector<PlannedProcess>& processes) {
  for (const config::SensorEntry& sensor : deployment.sensors) {
    if (!sensor.gives_pictures || sensor.source != "hardware") continue;
    for (const PlannedProcess& process : processes)
      if (process.name == sensor.name && process.host.empty())
        memories_.emplace(sensor.name, process::PictureMemory::create(sensor.picture_width(), sensor.picture_height()));
  }
}

int CameraMemories::fd_of(const std::string& process) const noexcept {
  const auto found = memories_.find(process);
  return found == memories_.end() ? -1 : found->second.fd();
}

std::map<std::string, std::string> CameraMemories::files() const {
  std::map<std::string, std::string> files;
  for (const auto& [camera, memory] : memories_)
    files[camera] = "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(memory.fd());
  return files;
}

}  // namespace mrroc::cli
