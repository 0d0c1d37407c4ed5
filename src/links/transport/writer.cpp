#include "links/transport/writer.hpp"

#include <atomic>

#include "clock/wall/monotonic.hpp"
#include "links/transport/entity.hpp"
#include "links/transport/incompatible.hpp"
#include "links/wire/codec.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::links {

template <class T>
struct Writer<T>::Impl {
  Impl(Domain& d, clock::Clock& c, const std::string& t, WriterOptions o) : boot(d.boot()), clock(c), topic(t) {
    dds_topic = create_topic(d, WireOf<T>::descriptor(), topic);
    if (o.counted) sender = clock.register_sender(topic);
    Listener listener{dds_create_listener(this)};
    dds_lset_offered_incompatible_qos(listener.get(), &on_incompatible);
    writer = Entity{dds_create_writer(d.participant(), dds_topic.get(), link_writer_qos(d).get(), listener.get()),
                    "writer", topic};
  }

  static void on_incompatible(dds_entity_t, const dds_offered_incompatible_qos_status_t status, void* arg) {
    static_cast<Impl*>(arg)->refused_policy.store(status.last_policy_id);
  }

  /// A message without content: only its header counts. On the stack, so that any thread may send one.
  void control(std::uint32_t kind, std::uint64_t answers) noexcept {
    Wire<T> message{};
    message.header.boot = boot;
    message.header.answers = answers;
    message.header.kind = kind;
    dds_write(writer.get(), &message);  // a lost one is repeated
  }

  const std::uint64_t boot;
  clock::Clock& clock;
  const std::string topic;
  int sender = -1;  // the clock's handle; -1: not counted
  Wire<T> sample{};
  std::atomic<std::uint32_t> refused_policy{0};
  Entity dds_topic;
  Entity writer;
};

template <class T>
Writer<T>::Writer(Domain& domain, clock::Clock& clock, const std::string& topic, WriterOptions options)
    : impl_(std::make_unique<Impl>(domain, clock, topic, options)) {}

template <class T>
Writer<T>::~Writer() = default;

template <class T>
void Writer<T>::write(const T& message, std::uint64_t sequence, std::uint64_t answers) {
  encode(message, impl_->sample);
  send(&impl_->sample, sequence, answers);
}

template <class T>
void Writer<T>::send(void* sample, std::uint64_t sequence, std::uint64_t answers) {
  Impl& link = *impl_;
  auto& header = static_cast<Wire<T>*>(sample)->header;
  header = {};
  header.kind = kData;
  header.boot = link.boot;
  header.number = sequence;
  header.answers = answers;
  if (link.clock.simulated()) {
    header.delta = link.clock.delta();
  } else {
    header.stamp_ns = clock::monotonic_ns() - link.clock.epoch_ns();
  }
  if (link.sender >= 0) link.clock.sent(link.sender);
  const dds_return_t code = dds_write(link.writer.get(), sample);
  if (code != DDS_RETCODE_OK) {
    throw SystemError(ErrorCode::link_lost, "topic " + link.topic + ": not written: " + dds_strretcode(code));
  }
}

template <class T>
const std::string& Writer<T>::topic() const noexcept {
  return impl_->topic;
}

template <class T>
void Writer<T>::ping() noexcept {
  impl_->control(kPing, 0);
}

template <class T>
void Writer<T>::pong(std::uint64_t boot) noexcept {
  impl_->control(kPong, boot);
}

template <class T>
std::string Writer<T>::problem() const {
  return incompatible(impl_->topic, impl_->refused_policy.load());
}

template <class T>
std::int32_t Writer<T>::entity() const noexcept {
  return impl_->writer.get();
}

template class Writer<RobotCommand>;
template class Writer<RobotState>;
template class Writer<SensorRequest>;
template class Writer<SensorReading>;
template class Writer<TaskCommand>;
template class Writer<TaskStatus>;
template class Writer<OperatorQuestion>;
template class Writer<OperatorAnswer>;
template class Writer<TrajectoryPart>;
template class Writer<TrajectoryReport>;

}  // namespace mrroc::links
