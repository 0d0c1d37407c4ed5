#include "drivers/netft/rdt_client.hpp"

#include <poll.h>
#include <sys/eventfd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include "clock/wall/wait.hpp"
#include "config/text/message_text.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::netft {

namespace {

/// The sensor counts its measurements at this rate, Hz; the bounds below allow for twice as much.
constexpr double kCountRate = 2 * kMaxRate;
/// A record may be older than one that has come by so many measurements, else the sensor has restarted.
constexpr std::uint32_t kMaxAge = 7000;
constexpr int kMaxPackets = 64;  // taken at once

[[noreturn]] void fail_by_system(const char* what) {
  throw std::system_error(errno, std::generic_category(), std::string("Net F/T: ") + what);
}

/// No signal interrupts the threads that begin while this exists.
class BlockedSignals {
 public:
  BlockedSignals() noexcept {
    sigset_t all;
    sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~BlockedSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

std::string disturbances(const RdtCounters& counters) {
  std::string text;
  const auto add = [&text](std::uint64_t count, const char* what) {
    if (count == 0) return;
    text += (text.empty() ? " " : ", ") + std::to_string(count) + " " + what;
  };
  add(counters.lost, "lost");
  add(counters.late, "late");
  add(counters.doubled, "doubled");
  add(counters.repeated, "without a new measurement");
  add(counters.invalid, "with an error of the sensor");
  add(counters.malformed, "other packets");
  add(counters.sensor_restarts, "restarts of the sensor");
  return text.empty() ? text : "of " + std::to_string(counters.records) + " records" + text;
}

RdtClient::RdtClient(const RdtOptions& options)
    : options_(options),
      timeout_ns_(to_ns(options.timeout)),
      period_ns_(to_ns(options.request_period)),
      socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)),
      end_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (!socket_.valid() || !end_.valid()) fail_by_system("no socket");
  const sockaddr_in address = resolve(options.address, options.port);
  if (::connect(socket_.get(), generic(address), sizeof address) != 0) fail_by_system("no route to the sensor");
  if (options.set_bias) set_bias();
  await_first();
  const BlockedSignals blocked;
  thread_ = std::thread([this] { serve(); });
}

RdtClient::~RdtClient() {
  const std::uint64_t one = 1;
  if (::write(end_.get(), &one, sizeof one) == sizeof one) thread_.join();
  send({Command::stop, 0});
}

const Measurement& RdtClient::newest() noexcept { return *handed_.load(); }

RdtCounters RdtClient::counters() const noexcept {
  RdtCounters counters;
  counters_.load(counters);
  return counters;
}

void RdtClient::await_first() {
  const std::int64_t deadline = clock::monotonic_ns() + to_ns(options_.start_timeout);
  int error = 0;
  for (std::int64_t now = clock::monotonic_ns(); !measured_; now = clock::monotonic_ns()) {
    if (now >= deadline) {
      std::string problem = ": no record within " + config::number_text(options_.start_timeout) + " s";
      if (error != 0) problem += " (" + std::generic_category().message(error) + ")";
      throw HardwareError(ErrorCode::sensor_hardware, place_text(options_.address, options_.port) + problem +
                                                          ", expected a Net F/T that sends by RDT over UDP");
    }
    if (now >= request_at_) request(now);
    if (!clock::wait_for(socket_.get(), POLLIN, std::min(deadline, request_at_))) continue;
    std::uint8_t byte = 0;
    // a host without the port refuses every request
    if (::recv(socket_.get(), &byte, 1, MSG_PEEK) < 0 && errno != EAGAIN) {
      error = errno;
      clock::wait_for(end_.get(), POLLIN, std::min(deadline, request_at_));
      continue;
    }
    receive();
  }
  publish_counters();
}

void RdtClient::serve() noexcept {
  std::array<pollfd, 2> both{{{socket_.get(), POLLIN, 0}, {end_.get(), POLLIN, 0}}};
  for (;;) {
    std::int64_t now = clock::monotonic_ns();
    if (now >= request_at_) request(now);
    const timespec limit = clock::to_timespec(std::max<std::int64_t>(request_at_ - now, 0));
    ::ppoll(both.data(), both.size(), &limit, nullptr);
    if (both[1].revents != 0) return;
    if (both[0].revents != 0) receive();
    publish_counters();
  }
}

/// Requests records, and sets the time of the next request.
void RdtClient::request(std::int64_t now) noexcept {
  sequence_.renew();
  ++counted_.requests;
  send({Command::start_realtime, period_ns_ > 0 ? 1u : 0u});
  const std::int64_t wait = period_ns_ > 0 ? period_ns_ : timeout_ns_;
  request_at_ = period_ns_ > 0 && request_at_ + wait > now ? request_at_ + wait : now + wait;
}

void RdtClient::send(const Request& request) noexcept {
  const auto packet = encode(request);
  // an error of an earlier packet is reported here: the next request is another attempt
  for (int i = 0; i < 2; ++i) {
    if (::send(socket_.get(), packet.data(), packet.size(), MSG_DONTWAIT | MSG_NOSIGNAL) >= 0) return;
  }
}

/// Takes the packets that have come; in a flood the others wait, so that the thread can end.
void RdtClient::receive() noexcept {
  std::array<std::uint8_t, kMaxPacketSize + 1> packet;
  for (int i = 0; i < kMaxPackets; ++i) {
    const ssize_t size = ::recv(socket_.get(), packet.data(), packet.size(), MSG_DONTWAIT);
    if (size < 0) return;
    take(std::span(packet).first(static_cast<std::size_t>(size)), clock::monotonic_ns());
  }
}

void RdtClient::take(std::span<const std::uint8_t> packet, std::int64_t now) noexcept {
  const std::size_t count = records_in(packet.size());
  if (count == 0) ++counted_.malformed;
  for (std::size_t i = 0; i < count; ++i) take(decode_record(packet, i), now);
}

void RdtClient::take(const Record& record, std::int64_t now) noexcept {
  ++counted_.records;
  const Place place = sequence_.add(record.rdt_sequence);
  if (place == Place::doubled || place == Place::late) return;
  if (!is_new(record, now)) {
    ++counted_.repeated;
    return;
  }
  if (!is_valid(record.status)) ++counted_.invalid;
  newest_ = {record, now, counted_.sensor_restarts};
  measured_ = true;
  if (period_ns_ == 0) request_at_ = now + timeout_ns_;
  handed_.store(newest_);
}

/// Whether the record is a later measurement than the newest one, or the first of a sensor that has restarted: its
/// count of measurements then begins again. A count that is only a little behind is that of an old record, unless
/// nothing newer has come since the request for a new stream.
bool RdtClient::is_new(const Record& record, std::int64_t now) noexcept {
  if (!measured_) return true;
  const std::uint32_t ahead = record.ft_sequence - newest_.record.ft_sequence;
  if (ahead == 0) return false;
  const double elapsed = static_cast<double>(now - newest_.arrival_ns) * 1e-9;
  if (static_cast<double>(ahead) <= kCountRate * (1 + elapsed)) return true;
  if (-ahead <= kMaxAge && now - newest_.arrival_ns < timeout_ns_) return false;
  ++counted_.sensor_restarts;
  return true;
}

void RdtClient::publish_counters() noexcept {
  counted_.lost = sequence_.lost();
  counted_.late = sequence_.late();
  counted_.doubled = sequence_.doubled();
  counters_.store(counted_);
}

}  // namespace mrroc::netft
