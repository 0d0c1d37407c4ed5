#include "drivers/ur/rtde_link.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <system_error>

#include "clock/wall/wait.hpp"
#include "drivers/ur/rtde/protocol_error.hpp"

namespace mrroc::ur {
namespace {

using rtde::PacketBuffer;
using rtde::PacketType;

constexpr int kWaitMs = 50;  // between two checks for a silent controller
constexpr std::int64_t kBetweenAttempts = clock::kSecond / 5;
constexpr double kFrequency = 500, kFrequencyOfCb3 = 125;
constexpr std::uint32_t kFirstMajorOfESeries = 5;
constexpr std::size_t kQueue = 4096;

void signal(int eventfd) noexcept {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(eventfd, &one, sizeof one);
}

void clear(int eventfd) noexcept {
  std::uint64_t count = 0;
  [[maybe_unused]] const ssize_t read = ::read(eventfd, &count, sizeof count);
}

std::int64_t after(double seconds) { return clock::monotonic_ns() + std::llround(seconds * 1e9); }

}  // namespace

RtdeLink::RtdeLink(const UrOptions& options, double servo_period)
    : options_(options), servo_period_(servo_period), queue_(kQueue) {
  for (int* const each : {&wake_, &received_})
    if ((*each = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) < 0)
      throw std::system_error(errno, std::generic_category(), "eventfd");
}

RtdeLink::~RtdeLink() {
  end_.store(true, std::memory_order_release);
  signal(wake_);
  if (thread_.joinable()) thread_.join();
  ::close(wake_);
  ::close(received_);
}

void RtdeLink::open() {
  if (thread_.joinable()) return;  // it is open
  connect_in_time();
  const std::int64_t deadline = after(options_.timeout);
  while (packages_.load(std::memory_order_relaxed) == 0) {
    if (!socket_.wait_readable(deadline)) throw ConnectionError(socket_.name() + ": no data package");
    receive();
    if (!socket_.is_open()) throw ConnectionError(reason_);
  }
  thread_ = std::thread([this] { run(); });
}

void RtdeLink::connect_in_time() {
  const std::int64_t deadline = after(options_.open_timeout);
  for (;;) {
    try {
      return connect();
    } catch (const ConnectionError&) {
      if (clock::monotonic_ns() >= deadline) throw;
    }
    clock::pause(kBetweenAttempts);
  }
}

/// The greatest that is not above the servo's, a fraction of the controller's own.
double RtdeLink::frequency_of(std::uint32_t major) const noexcept {
  if (options_.frequency != 0) return options_.frequency;
  const double own = major < kFirstMajorOfESeries ? kFrequencyOfCb3 : kFrequency;
  constexpr double kRounding = 1e-6;
  return own / std::max(std::ceil(own * servo_period_ - kRounding), 1.0);
}

/// Negotiates; on return packages arrive.
void RtdeLink::connect() {
  try {
    socket_ = TcpSocket("the RTDE interface", options_.address, options_.rtde_port, options_.timeout);
    buffer_.clear();
    text_.clear();
    queued_begin_ = queued_end_ = 0;
    const std::int64_t deadline = after(options_.timeout);
    const auto accepted = [this, deadline](PacketType type, const std::vector<std::uint8_t>& payload) {
      return rtde::Acceptance::from_payload(ask(type, payload, deadline).payload).accepted;
    };
    if (!accepted(PacketType::request_protocol_version, rtde::VersionRequest{}.payload()))
      throw rtde::ProtocolError("the controller refuses protocol version 2, its software must be 3.3 or newer");
    const auto version =
        rtde::ControllerVersion::from_payload(ask(PacketType::get_urcontrol_version, {}, deadline).payload);
    frequency_.store(frequency_of(version.major), std::memory_order_relaxed);

    const rtde::OutputsRequest outputs{frequency(), state_fields(options_.registers)};
    state_recipe_ = rtde::accepted_recipe(
        rtde::SetupReply::from_payload(ask(PacketType::setup_outputs, outputs.payload(), deadline).payload),
        outputs.names);
    state_values_.resize(outputs.names.size());
    set_points_ = set_up_inputs(set_point_fields(options_.registers), deadline);
    terminals_ = set_up_inputs(terminal_fields(), deadline);
    if (options_.speed_slider != 0) slider_ = set_up_inputs(slider_fields(), deadline);
    if (!accepted(PacketType::start, {})) throw rtde::ProtocolError("the controller refuses to start");
  } catch (const rtde::ProtocolError& error) {
    const std::string text = socket_.name() + ": " + error.what();
    disconnect(text);
    throw ConnectionError(text);
  } catch (const ConnectionError& error) {
    disconnect(error.what());
    throw;
  }
  clock_.start(1 / frequency());
  last_received_ = clock::monotonic_ns();
  outputs_.reset();
  if (options_.speed_slider != 0) {
    write_slider(options_.speed_slider, slider_.values);
    put(slider_);
  }
  connections_.fetch_add(1, std::memory_order_relaxed);
  up_.store(true, std::memory_order_release);
}

/// Sends a request and returns its answer. Texts and data packages that come before it are skipped.
rtde::Packet RtdeLink::ask(PacketType type, const std::vector<std::uint8_t>& payload, std::int64_t deadline) {
  std::vector<std::uint8_t> request;
  rtde::append_packet(request, type, payload);
  socket_.send_all(request, deadline);
  for (;;) {
    rtde::Packet packet;
    switch (buffer_.next(packet)) {
      case PacketBuffer::Next::packet:
        if (packet.type == type) return packet;
        if (packet.type == PacketType::text_message) keep_text(packet);
        if (packet.type != PacketType::text_message && packet.type != PacketType::data_package)
          throw rtde::ProtocolError("the answer is of another kind than the request");
        continue;
      case PacketBuffer::Next::broken:
        throw rtde::ProtocolError("the answer is not RTDE");
      case PacketBuffer::Next::incomplete:
        break;
    }
    if (!socket_.wait_readable(deadline)) throw ConnectionError(socket_.name() + ": no answer");
    const long size = socket_.receive(buffer_.free_space());
    if (size < 0) throw ConnectionError(end_of_connection());
    buffer_.filled(static_cast<std::size_t>(size));
  }
}

RtdeLink::Output RtdeLink::set_up_inputs(const std::vector<std::string>& fields, std::int64_t deadline) {
  const rtde::InputsRequest request{fields};
  Output output;
  output.recipe = rtde::accepted_recipe(
      rtde::SetupReply::from_payload(ask(PacketType::setup_inputs, request.payload(), deadline).payload), fields);
  for (const rtde::FieldType type : output.recipe.types) output.values.push_back(rtde::zero_of(type));
  return output;
}

/// A controller that refuses a package sends the reason as a text before it closes the connection.
void RtdeLink::keep_text(const rtde::Packet& packet) noexcept {
  try {
    text_ = rtde::TextMessage::from_payload(packet.payload).message;
  } catch (const rtde::ProtocolError&) {
    text_.clear();  // of no effect on the robot
  }
}

std::string RtdeLink::end_of_connection() const {
  std::string reason = socket_.name() + ": the controller has closed the connection";
  if (!text_.empty()) reason.append(": ").append(text_);
  return reason;
}

void RtdeLink::disconnect(const std::string& reason) noexcept {
  socket_.close();
  report(reason);
  up_.store(false, std::memory_order_release);
}

void RtdeLink::report(const std::string& reason) noexcept {
  reason_ = reason;
  problem_for_servo_.store(edp::DriverText(reason));
  problem_for_start_.store(edp::DriverText(reason));
}

void RtdeLink::run() noexcept {
  while (!end_.load(std::memory_order_acquire)) {
    if (!socket_.is_open()) reconnect();
    poll();
    if (!socket_.is_open()) continue;
    transmit();
    receive();
    if (socket_.is_open() && clock::monotonic_ns() - last_received_ > std::llround(options_.timeout * 1e9))
      disconnect(socket_.name() + ": no data package");
  }
  transmit();  // the servo's last command switches the drives off
  if (!socket_.is_open()) return;
  try {
    std::vector<std::uint8_t> pause;
    rtde::append_packet(pause, PacketType::pause, {});
    socket_.send(pause);
  } catch (const std::exception&) {  // the connection ends in any case
  }
}

void RtdeLink::reconnect() noexcept {
  try {
    connect();
  } catch (const std::exception& error) {
    report(error.what());
  }
}

/// Until the socket or the servo thread has something, or a while has passed.
void RtdeLink::poll() noexcept {
  std::array<pollfd, 2> entries{{{wake_, POLLIN, 0}, {socket_.fd(), POLLIN, 0}}};
  if (!queue_empty()) entries[1].events |= POLLOUT;
  if (socket_.is_open()) {
    ::poll(entries.data(), entries.size(), kWaitMs);
  } else {
    // the servo thread continues to hand set-points over: they must not make the attempts more frequent
    clock::pause(kBetweenAttempts);
  }
  clear(wake_);
}

bool RtdeLink::wait(std::int64_t deadline) noexcept {
  if (!clock::wait_for(received_, POLLIN, deadline)) return false;
  clear(received_);
  return true;
}

void RtdeLink::receive() noexcept {
  const std::uint64_t before = packages_.load(std::memory_order_relaxed);
  long size = 0;
  while (socket_.is_open() && (size = socket_.receive(buffer_.free_space())) > 0) {
    buffer_.filled(static_cast<std::size_t>(size));
    rtde::Packet packet;
    PacketBuffer::Next next = PacketBuffer::Next::incomplete;
    while (socket_.is_open() && (next = buffer_.next(packet)) == PacketBuffer::Next::packet) take(packet);
    if (next == PacketBuffer::Next::broken) disconnect(socket_.name() + ": the received bytes are not RTDE");
  }
  if (size < 0) disconnect(end_of_connection());
  const std::uint64_t taken = packages_.load(std::memory_order_relaxed) - before;
  if (taken == 0) return;
  bunched_.fetch_add(taken - 1, std::memory_order_relaxed);
  signal(received_);
}

void RtdeLink::take(const rtde::Packet& packet) noexcept {
  if (packet.type == PacketType::text_message) keep_text(packet);
  if (packet.type != PacketType::data_package) return;
  if (!rtde::decode_data(state_recipe_, packet.payload, state_values_) || !read_state(state_values_, state_))
    return disconnect(socket_.name() + ": a data package is not of the agreed recipe");
  last_received_ = state_.received = clock::monotonic_ns();
  state_.number = packages_.fetch_add(1, std::memory_order_relaxed) + 1;
  const edp::PackageClock::Verdict verdict = clock_.take(state_.timestamp, state_.received);
  lost_.fetch_add(verdict.lost, std::memory_order_relaxed);
  late_.fetch_add(verdict.late, std::memory_order_relaxed);
  doubled_.fetch_add(verdict.doubled, std::memory_order_relaxed);
  for_servo_.store(state_);
  for_start_.store(state_);
}

void RtdeLink::send(const Command& command) noexcept {
  commands_.store(command);
  signal(wake_);
}

void RtdeLink::transmit() noexcept {
  if (!socket_.is_open()) return;
  flush();
  const Command* const command = commands_.load();
  // a socket that takes nothing gets the newest set-points when it takes bytes again, not all of the missed ones
  if (command == nullptr || command->sequence == last_sequence_ || !queue_empty()) return;
  if (command->sets_outputs && outputs_ != command->outputs) {
    write_terminals(command->outputs, terminals_.values);
    put(terminals_);
    outputs_ = command->outputs;
  }
  const auto step = static_cast<std::uint32_t>(command->sequence) - static_cast<std::uint32_t>(last_sequence_);
  if (started_sending_) unsent_.fetch_add(step - 1, std::memory_order_relaxed);
  started_sending_ = true;
  last_sequence_ = command->sequence;
  write_set_points(*command, set_points_.values);
  put(set_points_);
  sent_.fetch_add(1, std::memory_order_relaxed);
  flush();
}

/// Appends to the queue, which is long enough for one package of each recipe.
void RtdeLink::put(const Output& output) noexcept {
  if (queue_empty()) queued_begin_ = queued_end_ = 0;
  queued_end_ += rtde::encode_data(output.recipe, output.values, std::span(queue_).subspan(queued_end_));
}

void RtdeLink::flush() noexcept {
  if (queue_empty() || !socket_.is_open()) return;
  const long size = socket_.send(std::span(queue_).subspan(queued_begin_, queued_end_ - queued_begin_));
  if (size < 0) return disconnect(end_of_connection());
  queued_begin_ += static_cast<std::size_t>(size);
}

LinkCounters RtdeLink::counters() const noexcept {
  constexpr auto kRelaxed = std::memory_order_relaxed;
  return {{packages_.load(kRelaxed), lost_.load(kRelaxed), doubled_.load(kRelaxed), late_.load(kRelaxed),
           bunched_.load(kRelaxed)},
          sent_.load(kRelaxed),
          unsent_.load(kRelaxed),
          connections_.load(kRelaxed)};
}

}  // namespace mrroc::ur
