#include "system/hosts/cable.hpp"

#include <fcntl.h>
#include <linux/ethtool.h>
#include <linux/if_packet.h>
#include <linux/sockios.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <netinet/in.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include "clock/wall/monotonic.hpp"

namespace mrroc::test {

namespace {

constexpr std::int64_t kHeldBack = 3'000'000;  // ns

[[noreturn]] void refuse(const std::string& what) { throw std::system_error(errno, std::generic_category(), what); }

int open_space(pid_t pid) {
  const int fd = open(("/proc/" + std::to_string(pid) + "/ns/net").c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) refuse("network namespace");
  return fd;
}

/// A device that offloads checksums would pass frames without checksums to the carrying thread.
void compute_checksums(const std::string& device) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  ethtool_value off{ETHTOOL_STXCSUM, 0};
  ifreq request{};
  device.copy(request.ifr_name, IFNAMSIZ - 1);
  request.ifr_data = reinterpret_cast<char*>(&off);
  const int result = ioctl(socket, SIOCETHTOOL, &request);
  close(socket);
  if (result != 0) refuse("checksums of " + device);
}

/// Receives all frames of a device, and sends frames.
int open_end(const std::string& device) {
  const int end = socket(AF_PACKET, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, htons(ETH_P_ALL));
  sockaddr_ll address{};
  address.sll_family = AF_PACKET;
  address.sll_protocol = htons(ETH_P_ALL);
  address.sll_ifindex = static_cast<int>(if_nametoindex(device.c_str()));
  if (end < 0 || bind(end, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) refuse("packet socket");
  return end;
}

}  // namespace

Namespace::Namespace() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) refuse("pipe");
  holder_ = fork();
  if (holder_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int problem = unshare(CLONE_NEWNET) == 0 ? 0 : errno;
    if (write(ends[1], &problem, sizeof problem) < 0 || problem != 0) _exit(1);
    for (;;) pause();
  }
  close(ends[1]);
  int problem = EIO;
  if (read(ends[0], &problem, sizeof problem) != sizeof problem) problem = EIO;
  close(ends[0]);
  if (problem == 0) {
    ip("link set lo up");
    return;
  }
  waitpid(holder_, nullptr, 0);
  errno = problem;
  refuse("the kernel refuses a network namespace");
}

Namespace::~Namespace() {
  kill(holder_, SIGKILL);
  waitpid(holder_, nullptr, 0);
}

std::vector<std::string> Namespace::command() const {
  return {"nsenter", "--net=/proc/" + std::to_string(holder_) + "/ns/net", "--"};
}

void Namespace::ip(const std::string& arguments) const {
  std::string line;
  for (const std::string& word : command()) line += word + " ";
  line += "ip " + arguments;
  if (std::system(line.c_str()) != 0) throw std::runtime_error(line);
}

Inside::Inside(const Namespace& space) : outside_(open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC)) {
  const int fd = open_space(space.holder());
  const int result = setns(fd, CLONE_NEWNET);
  close(fd);
  if (result != 0) refuse("setns");
}

Inside::~Inside() {
  if (setns(outside_, CLONE_NEWNET) != 0) std::abort();
  close(outside_);
}

/// A frame in transit to the end `to`.
struct Cable::Frame {
  std::int64_t due;
  int to;
  std::vector<char> bytes;
};

Cable::Cable(std::uint64_t seed) : random_(seed) {
  struct Side {
    const Namespace& space;
    const char* address;
    const char* end;
  };
  const Side sides[] = {{a_, kAddressOfA, "end0"}, {b_, kAddressOfB, "end1"}};
  for (const Side& side : sides) {
    middle_.ip("link add " + std::string{side.end} + " type veth peer name " + kDevice + " netns " +
               std::to_string(side.space.holder()));
    middle_.ip("link set " + std::string{side.end} + " up");
    side.space.ip("address add " + std::string{side.address} + "/24 dev " + kDevice);
    const Inside inside(side.space);
    compute_checksums(kDevice);
    side.space.ip("link set " + std::string{kDevice} + " up");
  }
  {
    const Inside inside(middle_);
    for (int i = 0; i < 2; ++i) ends_[i] = open_end(sides[i].end);
  }
  thread_ = std::thread([this] { carry(); });
}

Cable::~Cable() {
  ended_ = true;
  thread_.join();
  for (const int end : ends_) close(end);
}

void Cable::set(const CableFaults& faults) {
  const std::lock_guard lock(mutex_);
  faults_ = faults;
}

void Cable::set_mtu(int bytes) const {
  const std::string mtu = " mtu " + std::to_string(bytes);
  for (const char* const end : {"end0", "end1"}) middle_.ip("link set " + std::string{end} + mtu);
  for (const Namespace* const host : {&a_, &b_}) host->ip("link set " + std::string{kDevice} + mtu);
}

Cable::Counts Cable::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

void Cable::carry() {
  sched_param parameters{};
  parameters.sched_priority = 90;  // a cable is never late; without this priority it is slightly late
  sched_setscheduler(0, SCHED_FIFO, &parameters);
  const auto later = [](const Frame& one, const Frame& other) { return one.due > other.due; };
  std::vector<Frame> queue;  // a heap with the next frame in front
  while (!ended_) {
    std::int64_t wait = clock::kSecond / 50;
    if (!queue.empty()) wait = std::clamp<std::int64_t>(queue.front().due - clock::monotonic_ns(), 0, wait);
    const timespec pause = clock::to_timespec(wait);
    pollfd ends[] = {{ends_[0], POLLIN, 0}, {ends_[1], POLLIN, 0}};
    ppoll(ends, 2, &pause, nullptr);
    for (const int end : {0, 1}) receive(end, queue);
    while (!queue.empty() && queue.front().due <= clock::monotonic_ns()) {
      std::pop_heap(queue.begin(), queue.end(), later);
      const Frame& frame = queue.back();
      // a frame that does not fit into the socket is lost, as in a switch
      if (send(ends_[frame.to], frame.bytes.data(), frame.bytes.size(), 0) >= 0) {
        const std::lock_guard lock(mutex_);
        ++counts_.carried;
      }
      queue.pop_back();
    }
  }
}

void Cable::receive(int end, std::vector<Frame>& queue) {
  char buffer[65536];
  sockaddr_ll from{};
  socklen_t size = sizeof from;
  ssize_t length = 0;
  const auto later = [](const Frame& one, const Frame& other) { return one.due > other.due; };
  while ((length = recvfrom(ends_[end], buffer, sizeof buffer, 0, reinterpret_cast<sockaddr*>(&from), &size)) > 0) {
    if (from.sll_pkttype == PACKET_OUTGOING) continue;  // a frame of its own
    const std::lock_guard lock(mutex_);
    const auto happens = [this](double probability) {
      return probability > 0 && std::uniform_real_distribution<>(0, 1)(random_) < probability;
    };
    if (faults_.cut || happens(faults_.loss)) {
      ++counts_.lost;
      continue;
    }
    const double jitter = faults_.jitter > 0 ? std::uniform_real_distribution<>(0, faults_.jitter)(random_) : 0;
    Frame frame{clock::monotonic_ns() + static_cast<std::int64_t>((faults_.delay + jitter) * 1e9), 1 - end,
                std::vector<char>(buffer, buffer + length)};
    if (happens(faults_.reorder)) {
      frame.due += kHeldBack;
      ++counts_.reordered;
    }
    if (happens(faults_.corrupt) && length > ETH_HLEN) {
      const auto place = std::uniform_int_distribution<std::size_t>(ETH_HLEN, frame.bytes.size() - 1)(random_);
      frame.bytes[place] = static_cast<char>(frame.bytes[place] ^ (1 << (random_() % 8)));
      ++counts_.corrupted;
    }
    const int copies = happens(faults_.duplicate) ? 2 : 1;
    counts_.duplicated += static_cast<std::uint64_t>(copies - 1);
    for (int i = 0; i < copies; ++i) {
      queue.push_back(frame);
      std::push_heap(queue.begin(), queue.end(), later);
    }
  }
}

}  // namespace mrroc::test
