#include "drivers/ur/rtde_connection.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "clock/wall/monotonic.hpp"
#include "drivers/ur/rtde/protocol_error.hpp"

namespace mrroc::ur {
namespace {

using rtde::PacketBuffer;
using rtde::PacketType;

constexpr std::size_t kQueue = 4096;

/// The greatest fraction of a controller's own frequency whose period is not below `shortest`, s.
double fraction(double own, double shortest) noexcept {
  constexpr double kRounding = 1e-6;
  return own / std::max(std::ceil(own * shortest - kRounding), 1.0);
}

}  // namespace

RtdeConnection::RtdeConnection(RtdeOptions options) : options_(std::move(options)), queue_(kQueue) {}

/// Executes a part of the negotiation; an error ends the connection.
template <class Action>
auto RtdeConnection::agree(Action action) {
  try {
    return action();
  } catch (const rtde::ProtocolError& error) {
    close(name() + ": " + error.what());
    throw ConnectionError(reason_);
  } catch (const ConnectionError& error) {
    close(error.what());
    throw;
  }
}

void RtdeConnection::open(const std::vector<std::string>& outputs) {
  agree([&] {
    socket_ = TcpSocket("the RTDE interface", options_.address, options_.port, options_.timeout);
    buffer_.clear();
    text_.clear();
    queued_begin_ = queued_end_ = 0;
    if (!is_accepted(PacketType::request_protocol_version, rtde::VersionRequest{}.payload()))
      throw rtde::ProtocolError("the controller refuses protocol version 2, its software must be 3.3 or newer");
    version_ = rtde::ControllerVersion::from_payload(ask(PacketType::get_urcontrol_version, {}).payload);
    frequency_ = options_.frequency == 0 ? fraction(own_frequency(), options_.shortest) : options_.frequency;
    const rtde::OutputsRequest request{frequency_, outputs};
    recipe_ = rtde::accepted_recipe(
        rtde::SetupReply::from_payload(ask(PacketType::setup_outputs, request.payload()).payload), outputs);
    values_.resize(outputs.size());
  });
}

RtdeConnection::Input RtdeConnection::set_up_inputs(const std::vector<std::string>& fields) {
  return agree([&] {
    const rtde::InputsRequest request{fields};
    Input input;
    input.recipe = rtde::accepted_recipe(
        rtde::SetupReply::from_payload(ask(PacketType::setup_inputs, request.payload()).payload), fields);
    for (const rtde::FieldType type : input.recipe.types) input.values.push_back(rtde::zero_of(type));
    return input;
  });
}

void RtdeConnection::start() {
  agree([this] {
    if (!is_accepted(PacketType::start, {})) throw rtde::ProtocolError("the controller refuses to start");
  });
}

/// Sends a request and returns its answer. Texts and data packages that come before it are skipped.
rtde::Packet RtdeConnection::ask(PacketType type, const std::vector<std::uint8_t>& payload) {
  const std::int64_t deadline = clock::monotonic_ns() + std::llround(options_.timeout * 1e9);
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
    if (!socket_.wait_readable(deadline)) throw ConnectionError(name() + ": no answer");
    const long size = socket_.receive(buffer_.free_space());
    if (size < 0) throw ConnectionError(end_of_connection());
    buffer_.filled(static_cast<std::size_t>(size));
  }
}

bool RtdeConnection::is_accepted(PacketType type, const std::vector<std::uint8_t>& payload) {
  return rtde::Acceptance::from_payload(ask(type, payload).payload).accepted;
}

const std::vector<rtde::Value>* RtdeConnection::next() noexcept {
  while (is_open()) {
    rtde::Packet packet;
    switch (buffer_.next(packet)) {
      case PacketBuffer::Next::packet:
        if (packet.type == PacketType::text_message) keep_text(packet);
        if (packet.type != PacketType::data_package) continue;
        if (rtde::decode_data(recipe_, packet.payload, values_)) return &values_;
        close(name() + ": a data package is not of the agreed recipe");
        return nullptr;
      case PacketBuffer::Next::broken:
        close(name() + ": the received bytes are not RTDE");
        return nullptr;
      case PacketBuffer::Next::incomplete:
        break;
    }
    const long size = socket_.receive(buffer_.free_space());
    if (size == 0) return nullptr;
    if (size < 0) {
      close(end_of_connection());
      return nullptr;
    }
    buffer_.filled(static_cast<std::size_t>(size));
  }
  return nullptr;
}

void RtdeConnection::put(const Input& input) noexcept {
  if (!has_unsent()) queued_begin_ = queued_end_ = 0;
  queued_end_ += rtde::encode_data(input.recipe, input.values, std::span(queue_).subspan(queued_end_));
}

void RtdeConnection::flush() noexcept {
  if (!has_unsent() || !is_open()) return;
  const long size = socket_.send(std::span(queue_).subspan(queued_begin_, queued_end_ - queued_begin_));
  if (size < 0) return close(end_of_connection());
  queued_begin_ += static_cast<std::size_t>(size);
}

void RtdeConnection::pause() noexcept {
  if (!is_open()) return;
  try {
    std::vector<std::uint8_t> request;
    rtde::append_packet(request, PacketType::pause, {});
    socket_.send(request);
  } catch (const std::exception&) {  // the connection ends in any case
  }
}

void RtdeConnection::close(const std::string& reason) noexcept {
  reason_ = reason;
  socket_.close();
}

/// A controller that refuses a package sends the reason as a text before it closes the connection.
void RtdeConnection::keep_text(const rtde::Packet& packet) noexcept {
  try {
    text_ = rtde::TextMessage::from_payload(packet.payload).message;
  } catch (const rtde::ProtocolError&) {
    text_.clear();  // of no effect on the robot
  }
}

std::string RtdeConnection::end_of_connection() const {
  std::string reason = name() + ": the controller has closed the connection";
  if (!text_.empty()) reason.append(": ").append(text_);
  return reason;
}

}  // namespace mrroc::ur
