#include "soak/resident.hpp"

#include <fstream>
#include <sstream>

namespace mrroc::soak {

namespace {

/// KiB of a mapping for one of Cyclone's receive buffers: 1 MiB and a page. The kernel may show several as one.
constexpr long kReceiveBuffer = 1028;

Resident resident_of(const std::string& pid) {
  std::ifstream file("/proc/" + pid + "/smaps");
  Resident resident;
  long size = 0;  // of the mapping
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string key;
    long value = 0;
    if (!(words >> key >> value)) continue;
    if (key == "Size:") size = value;
    if (key == "Rss:") (size > 0 && size % kReceiveBuffer == 0 ? resident.receive_buffers : resident.others) += value;
  }
  return resident;
}

/// The argument of `--name` on its command line.
std::string name_of(const std::string& pid) {
  std::ifstream file("/proc/" + pid + "/cmdline");
  bool named = false;
  for (std::string word; std::getline(file, word, '\0');) {
    if (named) return word;
    named = word == "--name";
  }
  return pid;
}

}  // namespace

std::map<std::string, Resident> resident(pid_t runner) {
  const std::string pid = std::to_string(runner);
  std::map<std::string, Resident> sizes{{"runner", resident_of(pid)}};
  std::ifstream children("/proc/" + pid + "/task/" + pid + "/children");
  for (std::string child; children >> child;) sizes[name_of(child)] = resident_of(child);
  return sizes;
}

}  // namespace mrroc::soak
