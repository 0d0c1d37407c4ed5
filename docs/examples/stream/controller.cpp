#include <arpa/inet.h>

#include <algorithm>
#include <cstdlib>

#include "packet.hpp"

/// Stands in for the controller: `stream_controller PORT`. In a packet each axis comes a third nearer to its set-point,
/// but by no more than 0.00044 rad: 0.22 rad/s at 500 packets a second, also after packets that were lost.
int main(int argc, char** argv) {
  const int s = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in here{AF_INET, htons(static_cast<unsigned short>(argc > 1 ? std::atoi(argv[1]) : 0)), {}, {}}, there{};
  if (bind(s, reinterpret_cast<sockaddr*>(&here), sizeof here) != 0) return 1;
  for (Packet packet{}, state{};;) {
    socklen_t size = sizeof there;
    if (recvfrom(s, &packet, sizeof packet, 0, reinterpret_cast<sockaddr*>(&there), &size) != sizeof packet) continue;
    for (int i = 0; packet.enabled != 0 && i < 8; ++i)
      state.position[i] += std::clamp((packet.position[i] - state.position[i]) / 3, -0.00044, 0.00044);
    state.tick = packet.tick;
    sendto(s, &state, sizeof state, 0, reinterpret_cast<sockaddr*>(&there), size);
  }
}
