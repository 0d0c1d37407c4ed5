#include <arpa/inet.h>

#include <cstdlib>

#include "packet.hpp"

/// Stands in for the controller: `stream_controller PORT`. It interpolates set-points, also across lost packets.
int main(int argc, char** argv) {
  const int s = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in here{AF_INET, htons(static_cast<unsigned short>(argc > 1 ? std::atoi(argv[1]) : 0)), {}, {}}, there{};
  if (bind(s, reinterpret_cast<sockaddr*>(&here), sizeof here) != 0) return 1;
  for (Packet packet{}, target{}, state{};;) {
    socklen_t size = sizeof there;
    if (recvfrom(s, &packet, sizeof packet, 0, reinterpret_cast<sockaddr*>(&there), &size) != sizeof packet) continue;
    for (; state.tick < packet.tick; ++state.tick)
      for (int i = 0; i < 8; ++i) {
        target.position[i] += (packet.position[i] - target.position[i]) / double(packet.tick - state.tick);
        if (packet.enabled != 0) state.position[i] += (target.position[i] - state.position[i]) / 3;
      }
    state.tick = packet.tick;
    sendto(s, &state, sizeof state, 0, reinterpret_cast<sockaddr*>(&there), size);
  }
}
