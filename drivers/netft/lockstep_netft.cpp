#include "drivers/netft/lockstep_netft.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <span>
#include <system_error>

#include "clock/wall/sliced_wait.hpp"
#include "clock/wall/wait.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::netft {

LockstepNetft::LockstepNetft(const NetftOptions& options, const Calibration& calibration, double period)
    : calibration_(calibration),
      period_(period),
      socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  const sockaddr_in address = resolve(options.address, options.port);
  if (!socket_.valid() || ::connect(socket_.get(), generic(address), sizeof address) != 0)
    throw std::system_error(errno, std::generic_category(), "Net F/T: no socket, or no route to the sensor");
  if (options.set_bias) set_bias(options);
}

/// RDT does not confirm it: repeats it until the record shows it.
void LockstepNetft::set_bias(const NetftOptions& options) {
  const auto is_zero = [](std::int32_t count) { return count == 0; };
  const bool taken = clock::wait_in_slices(to_ns(options.start_timeout), [&](std::int64_t deadline) {
    if (request({Command::set_bias, 0}) && request({Command::start_realtime, 1}) && receive(0, deadline) &&
        std::all_of(record_.counts.begin(), record_.counts.end(), is_zero))
      return true;
    clock::pause(deadline - clock::monotonic_ns());  // a stand-in that is still starting refuses the request
    return false;
  });
  refused_ = false;
  if (taken) return;
  throw HardwareError(ErrorCode::sensor_hardware,
                      place_text(options.address, options.port) + ": the simulated Net F/T does not take its zero");
}

vsp::SourceState LockstepNetft::read(Tick wanted, vsp::RawReading& raw) noexcept {
  lost_ = lost_ || !measure(wanted);
  if (lost_) return vsp::SourceState::silent;
  if (!is_valid(record_.status)) {
    fault_ = fault_of(record_);
    return vsp::SourceState::faulty;
  }
  raw.tick = wanted;
  fill(calibration_, record_, raw);
  return vsp::SourceState::ready;
}

/// Takes the record of this tick. False: the stand-in has ended, or does not answer.
bool LockstepNetft::measure(Tick tick) noexcept {
  bool ended = false;
  const bool over = clock::wait_in_slices(kTimeout, [&](std::int64_t deadline) {
    if (!request({Command::start_realtime, 1})) return ended = true;
    const bool there = receive(tick, deadline);
    ended = refused_;
    return there || ended;
  });
  return over && !ended;
}

bool LockstepNetft::request(const Request& request) noexcept {
  const auto packet = encode(request);
  return ::send(socket_.get(), packet.data(), packet.size(), MSG_NOSIGNAL) >= 0;
}

/// False: `deadline` came first, or the request was refused.
bool LockstepNetft::receive(Tick tick, std::int64_t deadline) noexcept {
  const std::uint32_t expected = measurements_until(to_ns(static_cast<double>(tick) * period_));
  for (;;) {
    std::array<std::uint8_t, kRecordSize + 1> packet{};
    const ssize_t size = ::recv(socket_.get(), packet.data(), packet.size(), 0);
    refused_ = size < 0 && errno != EAGAIN && errno != EINTR;
    if (refused_) return false;
    if (size == kRecordSize) {
      record_ = decode_record(std::span(packet).first(kRecordSize));
      if (record_.ft_sequence == expected) return true;  // else the answer to a repeated request of an earlier tick
    }
    if (size < 0 && !clock::wait_for(socket_.get(), POLLIN, deadline)) return false;
  }
}

}  // namespace mrroc::netft
