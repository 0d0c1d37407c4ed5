// Cost of the lockstep clock: microseconds of wall and CPU time per tick with six processes that only wait for the next
// tick (one of them is the simulated world, so a tick has two deltas), and with five of them passing one message each
// per tick over Unix sockets (so a tick has three).
//   clock_tick [ticks]

#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "clock/host.hpp"
#include "clock/participant.hpp"
#include "clock/wall/monotonic.hpp"
#include "clock/wall/realtime.hpp"

namespace {

using namespace mrroc;

constexpr std::size_t kProcesses = 6;

std::string name(std::size_t process) { return std::string("p").append(std::to_string(process)); }

struct Network {
  std::array<std::array<int, 2>, kProcesses> sockets{};
};

/// Process 0 is the world; 1..5 are a ring of senders.
void take_part(int fd, std::size_t process, bool messages, const Network& network) {
  const auto clock = clock::attach_clock(fd, name(process), process == 0 ? clock::Part::world : clock::Part::task);
  const std::size_t next = process % (kProcesses - 1) + 1;
  const std::size_t previous = (process + kProcesses - 3) % (kProcesses - 1) + 1;
  const bool talks = messages && process != 0;
  int sender = -1;
  if (talks) {
    sender = clock->register_sender(name(process));
    const int receiver = clock->register_receiver(name(previous));
    std::thread([&network, process, receiver, &timer = *clock] {
      for (char byte = 0; ::recv(network.sockets[process][0], &byte, 1, 0) == 1;) timer.arrived(receiver);
    }).detach();
  }
  for (bool running = clock->start(); running;) {
    if (talks) {
      clock->sent(sender);
      if (::send(network.sockets[next][1], "", 1, 0) != 1) std::abort();
    }
    clock::Wake wake = clock->wait(clock->tick() + 1);
    while (wake == clock::Wake::mail) wake = clock->wait(clock->tick() + 1);
    running = wake == clock::Wake::tick;
  }
  ::_exit(0);
}

/// User and system time of this process and of those that it has waited for, ns.
std::int64_t cpu_ns() {
  std::int64_t sum = 0;
  for (const int scope : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    ::getrusage(scope, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime})
      sum += time.tv_sec * clock::kSecond + time.tv_usec * 1000;
  }
  return sum;
}

struct Cost {
  double wall;  // us per tick
  double cpu;   // us per tick, all processes
};

Cost measure(Tick ticks, bool messages) {
  const std::int64_t cpu = cpu_ns();
  clock::HostOptions options;
  for (std::size_t i = 0; i < kProcesses; ++i) options.participants.push_back(name(i));
  clock::ClockHost host(options);
  Network network;
  for (auto& pair : network.sockets)
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET, 0, pair.data()) != 0) std::abort();
  for (std::size_t i = 0; i < kProcesses; ++i)
    if (::fork() == 0) take_part(host.fd(), i, messages, network);
  if (!host.wait_ready(30).empty()) std::abort();
  std::int64_t begin = 0;
  host.at_tick(1, [&begin](Tick) { begin = clock::monotonic_ns(); });
  std::int64_t end = 0;
  host.at_tick(ticks, [&](Tick) {
    end = clock::monotonic_ns();
    host.end();
  });
  host.start();
  for (std::size_t i = 0; i < kProcesses; ++i) ::wait(nullptr);
  for (const auto& pair : network.sockets)
    for (const int socket : pair) ::close(socket);
  return {static_cast<double>(end - begin) * 1e-3 / static_cast<double>(ticks - 1),
          static_cast<double>(cpu_ns() - cpu) * 1e-3 / static_cast<double>(ticks)};
}

void print_row(const char* where, Tick ticks) {
  const Cost silent = measure(ticks, false);
  const Cost talking = measure(ticks, true);
  std::printf("%-8s %8.1f %8.1f   %8.1f %8.1f\n", where, silent.wall, silent.cpu, talking.wall, talking.cpu);
  std::fflush(stdout);  // before the next processes are forked
}

}  // namespace

int main(int count, char** arguments) {
  const Tick ticks = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 20000;
  std::printf("us/tick    ticks only        with 5 messages\n%-8s %8s %8s   %8s %8s\n", "", "wall", "cpu", "wall",
              "cpu");
  std::fflush(stdout);
  print_row("spread", ticks);
  if (clock::pin_to_one_cpu() < 0) return 1;
  print_row("pinned", ticks);
}
