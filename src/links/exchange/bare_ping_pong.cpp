#include "links/exchange/bare_ping_pong.hpp"

#include <thread>

#include "clock/gate.hpp"
#include "clock/wall/monotonic.hpp"
#include "links/transport/entity.hpp"
#include "links/transport/topic_name.hpp"
#include "messages.h"
#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

constexpr std::int64_t kRetry = 20'000'000;             // ns
constexpr std::int64_t kSilence = 20 * clock::kSecond;  // longer than any stall of a busy machine

Entity create_writer(const Domain& domain, const Entity& topic, const std::string& name) {
  return {dds_create_writer(domain.participant(), topic.get(), link_writer_qos(domain).get(), nullptr), "writer", name};
}

Entity create_reader(const Domain& domain, const Entity& topic, const std::string& name,
                     dds_on_data_available_fn on_data, void* argument) {
  const Listener listener{dds_create_listener(argument)};
  dds_lset_data_available(listener.get(), on_data);
  return {dds_create_reader(domain.participant(), topic.get(), link_reader_qos().get(), listener.get()), "reader",
          name};
}

template <class Message>
bool take(dds_entity_t reader, Message& message) {
  dds_sample_info_t info;
  void* samples[] = {&message};
  while (dds_take(reader, samples, &info, 1, 1) == 1) {
    if (info.valid_data) return true;
  }
  return false;
}

void open_gate(dds_entity_t, void* gate) { static_cast<clock::Gate*>(gate)->open(); }

}  // namespace

struct BarePing::Impl {
  Impl(const Domain& domain, const std::string& command_name, const std::string& state_name)
      : command_topic(create_topic(domain, mrroc_wire_RobotCommand_desc, command_name)),
        state_topic(create_topic(domain, mrroc_wire_RobotState_desc, state_name)),
        writer(create_writer(domain, command_topic, command_name)),
        reader(create_reader(domain, state_topic, state_name, &open_gate, &gate)) {}

  bool exchange(std::int64_t deadline) {
    ++command.header.number;
    std::uint32_t seen = gate.word();
    dds_write(writer.get(), &command);
    for (;;) {
      if (!gate.sleep(seen, deadline)) return false;
      seen = gate.word();
      while (take(reader.get(), state)) {
        if (state.header.number == command.header.number) return true;
      }
    }
  }

  mrroc_wire_RobotCommand command{};
  mrroc_wire_RobotState state{};
  clock::Gate gate;
  Entity command_topic;
  Entity state_topic;
  Entity writer;
  Entity reader;  // deleted first: no listener runs after that
};

BarePing::BarePing(Domain& domain, const std::string& prefix)
    : impl_(std::make_unique<Impl>(domain, topic_name(prefix, "command"), topic_name(prefix, "state"))) {}

BarePing::~BarePing() = default;

void BarePing::connect(double timeout) {
  const std::int64_t end = clock::monotonic_ns() + static_cast<std::int64_t>(timeout * 1e9);
  while (!impl_->exchange(clock::monotonic_ns() + kRetry)) {
    if (clock::monotonic_ns() > end) throw SystemError(ErrorCode::link_lost, "the bare ping-pong receives no echo");
  }
}

void BarePing::exchange() {
  if (!impl_->exchange(clock::monotonic_ns() + kSilence)) {
    throw SystemError(ErrorCode::link_lost, "the bare ping-pong has lost its echo");
  }
}

struct BareEcho::Impl {
  Impl(const Domain& domain, const std::string& command_name, const std::string& state_name, Where where)
      : command_topic(create_topic(domain, mrroc_wire_RobotCommand_desc, command_name)),
        state_topic(create_topic(domain, mrroc_wire_RobotState_desc, state_name)),
        writer(create_writer(domain, state_topic, state_name)),
        reader(where == Where::thread ? create_reader(domain, command_topic, command_name, &open_gate, &gate)
                                      : create_reader(domain, command_topic, command_name, &answer_in_listener, this)) {
    if (where == Where::thread) thread = std::thread([this] { run(); });
  }

  ~Impl() {
    gate.interrupt();
    if (thread.joinable()) thread.join();
  }

  static void answer_in_listener(dds_entity_t entity, void* argument) { static_cast<Impl*>(argument)->answer(entity); }

  void answer(dds_entity_t entity) {
    while (take(entity, command)) {
      state.header.number = command.header.number;
      dds_write(writer.get(), &state);
    }
  }

  void run() {
    for (std::uint32_t seen = 0; !gate.interrupted();) {
      gate.sleep(seen, clock::kForever);
      seen = gate.word();
      answer(reader.get());
    }
  }

  mrroc_wire_RobotCommand command{};
  mrroc_wire_RobotState state{};
  clock::Gate gate;
  Entity command_topic;
  Entity state_topic;
  Entity writer;
  Entity reader;  // deleted first: no listener runs after that
  std::thread thread;
};

BareEcho::BareEcho(Domain& domain, const std::string& prefix, Where where)
    : impl_(std::make_unique<Impl>(domain, topic_name(prefix, "command"), topic_name(prefix, "state"), where)) {}

BareEcho::~BareEcho() = default;

}  // namespace mrroc::links
