#include "links/transport/reader.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>

#include "clock/wall/monotonic.hpp"
#include "links/transport/entity.hpp"
#include "links/transport/incompatible.hpp"
#include "links/transport/message_ring.hpp"
#include "links/wire/codec.hpp"

namespace mrroc::links {
namespace {

/// s: no message is too old.
constexpr double kForever = std::numeric_limits<double>::infinity();

Header header_of(const mrroc_wire_Header& wire) noexcept {
  return {wire.number, wire.boot, wire.answers, wire.delta, wire.stamp_ns};
}

}  // namespace

template <class T>
struct Reader<T>::Impl {
  using Ring = MessageRing<Wire<T>>;

  Impl(Domain& d, clock::Clock& c, const std::string& t, ReaderOptions o)
      : boot(d.boot()), clock(c), topic(t), options(std::move(o)), ring(std::max<std::size_t>(options.depth, 1)) {
    dds_topic = create_topic(d, WireOf<T>::descriptor(), topic);
    if (options.counted) receiver = clock.register_receiver(topic);
    // set at creation: a listener set after data has arrived is not called for it
    Listener listener{dds_create_listener(this)};
    dds_lset_data_available(listener.get(), &on_data);
    dds_lset_liveliness_changed(listener.get(), &on_liveliness);
    dds_lset_requested_incompatible_qos(listener.get(), &on_incompatible);
    reader = Entity{dds_create_reader(d.participant(), dds_topic.get(), link_reader_qos().get(), listener.get()),
                    "reader", topic};
  }

  // ---- Cyclone's threads; it calls one callback of a reader at a time ----------------------------------------------

  static void on_data(dds_entity_t reader, void* arg) {
    Impl& self = *static_cast<Impl*>(arg);
    std::array<dds_sample_info_t, Ring::kIncoming> infos;
    // room for one more than usual: if it stays empty there is nothing else
    for (dds_return_t count = Ring::kIncoming; count == Ring::kIncoming;) {
      void* samples[] = {&self.ring.incoming(0), &self.ring.incoming(1)};
      count = dds_take(reader, samples, infos.data(), infos.size(), infos.size());
      for (std::size_t i = 0; static_cast<dds_return_t>(i) < count; ++i)
        if (infos[i].valid_data) self.store(i);
    }
  }

  static void on_liveliness(dds_entity_t, const dds_liveliness_changed_status_t status, void* arg) {
    Impl& self = *static_cast<Impl*>(arg);
    self.alive.store(status.alive_count);
    self.clock.notify();
  }

  static void on_incompatible(dds_entity_t, const dds_requested_incompatible_qos_status_t status, void* arg) {
    static_cast<Impl*>(arg)->refused_policy.store(status.last_policy_id);
  }

  void store(std::size_t i) noexcept {
    const mrroc_wire_Header& header = ring.incoming(i).header;
    switch (header.kind) {
      case kData:
        ring.push(i);
        if (receiver >= 0) {
          clock.arrived(receiver);
        } else {
          clock.notify();
        }
        break;
      case kPing:
        for (WriterBase* writer : options.answer_through) writer->pong(header.boot);
        break;
      case kPong:
        if (header.answers == boot) responder.store(header.boot);
        break;
      default:
        unknown_kinds.fetch_add(1);
    }
  }

  // ---- the participant's thread ------------------------------------------------------------------------------------

  /// The oldest message that is visible; null when there is none.
  const Wire<T>* front() noexcept {
    const Wire<T>* const message = ring.front();
    return message != nullptr && (receiver < 0 || clock.visible(message->header.delta)) ? message : nullptr;
  }

  bool take(T& message, Header& header) noexcept {
    while (front() != nullptr) {
      taken = &ring.pop();
      if (decode(*taken, message)) {
        header = header_of(taken->header);
        return true;
      }
      ++malformed;
    }
    return false;
  }

  bool take_answer(T& message, const Header& expected) noexcept {
    while (const Wire<T>* const next = front()) {
      const Header header = header_of(next->header);
      if (header.sequence != expected.sequence || header.boot != expected.boot || header.answers != expected.answers) {
        ++stale;
        ring.drop();
        continue;
      }
      taken = &ring.pop();
      if (decode(*taken, message)) return true;
      ++malformed;
    }
    return false;
  }

  bool take_fresh(T& message, Header& header, double max_age) noexcept {
    Wire<T>* newest = nullptr;
    while (const Wire<T>* const next = front()) {
      if (!valid<T>(*next)) {
        ++malformed;
        ring.drop();
        continue;
      }
      if (newest != nullptr) ++stale;
      newest = &ring.pop();
    }
    if (newest == nullptr) return false;
    const Header newest_header = header_of(newest->header);
    if (!fresh(newest_header, max_age)) {
      ++stale;
      return false;
    }
    taken = newest;
    header = newest_header;
    return decode(*taken, message);
  }

  bool fresh(const Header& header, double max_age) const noexcept {
    if (clock.simulated() || max_age == kForever) return true;
    const std::int64_t epoch = clock.epoch_ns();
    if (epoch == 0 && !same_machine(header.boot, boot)) return true;  // before tick 0 hosts have no time in common
    return static_cast<double>(clock::monotonic_ns() - epoch - header.stamp_ns) * 1e-9 <= max_age;
  }

  const std::uint64_t boot;
  clock::Clock& clock;
  const std::string topic;
  const ReaderOptions options;
  int receiver = -1;  // the clock's handle; -1: not counted

  Ring ring;
  std::atomic<std::uint32_t> alive{0};
  std::atomic<std::uint32_t> refused_policy{0};
  std::atomic<std::uint64_t> responder{0};
  std::atomic<std::uint64_t> unknown_kinds{0};

  Wire<T>* taken = nullptr;  // participant: the message taken last
  std::uint64_t malformed = 0;
  std::uint64_t stale = 0;
  T held;  // of `latest`
  bool holds = false;

  Entity dds_topic;
  Entity reader;  // deleted first: no listener runs after that
};

template <class T>
Reader<T>::Reader(Domain& domain, clock::Clock& clock, const std::string& topic, ReaderOptions options)
    : impl_(std::make_unique<Impl>(domain, clock, topic, std::move(options))) {}

template <class T>
Reader<T>::~Reader() = default;

template <class T>
bool Reader<T>::take(T& message, Header& header) {
  return impl_->take(message, header);
}

template <class T>
bool Reader<T>::take_newest(T& message, Header& header) {
  return impl_->take_fresh(message, header, kForever);
}

template <class T>
bool Reader<T>::take_fresh(T& message, Header& header, double max_age) {
  return impl_->take_fresh(message, header, max_age);
}

template <class T>
bool Reader<T>::take_answer(T& message, const Header& expected) {
  return impl_->take_answer(message, expected);
}

template <class T>
bool Reader<T>::latest(T& message) {
  Header header;
  impl_->holds = impl_->take_fresh(impl_->held, header, kForever) || impl_->holds;
  if (impl_->holds) message = impl_->held;
  return impl_->holds;
}

template <class T>
bool Reader<T>::fresh(const Header& header, double max_age) const noexcept {
  return impl_->fresh(header, max_age);
}

template <class T>
void Reader<T>::forward(Writer<T>& writer, std::uint64_t sequence, std::uint64_t answers) {
  writer.send(impl_->taken, sequence, answers);
}

template <class T>
bool Reader<T>::peer_alive() const noexcept {
  return impl_->alive.load() > 0;
}

template <class T>
ReaderCounters Reader<T>::counters() const noexcept {
  return {impl_->malformed + impl_->unknown_kinds.load(), impl_->stale, impl_->ring.overwritten()};
}

template <class T>
const std::string& Reader<T>::topic() const noexcept {
  return impl_->topic;
}

template <class T>
void Reader<T>::expect_pong() noexcept {
  impl_->responder.store(0);
}

template <class T>
std::uint64_t Reader<T>::ponged() const noexcept {
  return impl_->responder.load();
}

template <class T>
std::string Reader<T>::problem() const {
  return incompatible(impl_->topic, impl_->refused_policy.load());
}

template <class T>
std::int32_t Reader<T>::entity() const noexcept {
  return impl_->reader.get();
}

template class Reader<RobotCommand>;
template class Reader<RobotState>;
template class Reader<SensorRequest>;
template class Reader<SensorReading>;
template class Reader<TaskCommand>;
template class Reader<TaskStatus>;
template class Reader<OperatorQuestion>;
template class Reader<OperatorAnswer>;
template class Reader<TrajectoryPart>;
template class Reader<TrajectoryReport>;

}  // namespace mrroc::links
