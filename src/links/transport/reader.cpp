#include "links/transport/reader.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>

#include "clock/wall/monotonic.hpp"
#include "links/transport/entity.hpp"
#include "links/transport/incompatible.hpp"
#include "links/transport/message_ring.hpp"
#include "links/wire/codec.hpp"

namespace mrroc::links {
namespace {

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
    std::array<dds_sample_info_t, 2> infos;
    void* samples[] = {&self.incoming[0].value, &self.incoming[1].value};
    // room for one more than usual: if it stays empty there is nothing else
    for (dds_return_t count = 2; count == 2;) {
      count = dds_take(reader, samples, infos.data(), 2, 2);
      for (dds_return_t i = 0; i < count; ++i) {
        if (infos[static_cast<std::size_t>(i)].valid_data) self.store(self.incoming[static_cast<std::size_t>(i)]);
      }
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

  void store(typename Ring::Entry& message) noexcept {
    const mrroc_wire_Header& header = message.value.header;
    switch (header.kind) {
      case kData:
        ring.push(message);
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

  /// Skips messages that have been overwritten since the last call.
  void skip_overwritten(std::uint64_t pushed) noexcept {
    if (pushed - next <= ring.depth()) return;
    overwritten += pushed - ring.depth() - next;
    next = pushed - ring.depth();
  }

  bool visible() const noexcept { return receiver < 0 || clock.visible(entry.value.header.delta); }

  bool take(T& message, Header& header) noexcept {
    const std::uint64_t pushed = ring.pushed();
    skip_overwritten(pushed);
    while (next < pushed) {
      const bool there = ring.read(next, entry);
      if (there && !visible()) return false;
      ++next;
      if (!there) {
        ++overwritten;
      } else if (decode(entry.value, message)) {
        header = header_of(entry.value.header);
        return true;
      } else {
        ++malformed;
      }
    }
    return false;
  }

  bool take_newest(T& message, Header& header) noexcept {
    const std::uint64_t pushed = ring.pushed();
    skip_overwritten(pushed);
    std::uint64_t end = next;  // of what is visible
    for (std::uint64_t n = pushed; n > next;) {
      --n;
      if (!ring.read(n, entry)) {
        overwritten += n + 1 - next;
        end = std::max(end, n + 1);
        break;
      }
      if (!visible()) continue;
      end = std::max(end, n + 1);
      if (decode(entry.value, message)) {
        stale += n - next;
        next = end;
        header = header_of(entry.value.header);
        return true;
      }
      ++malformed;
    }
    next = end;
    return false;
  }

  bool fresh(const Header& header, double max_age) const noexcept {
    if (clock.simulated()) return true;
    const std::int64_t epoch = clock.epoch_ns();
    if (epoch == 0 && !same_machine(header.boot, boot)) return true;  // before tick 0 hosts have no time in common
    return static_cast<double>(clock::monotonic_ns() - epoch - header.stamp_ns) * 1e-9 <= max_age;
  }

  const std::uint64_t boot;
  clock::Clock& clock;
  const std::string topic;
  const ReaderOptions options;
  int receiver = -1;  // the clock's handle; -1: not counted

  std::array<typename Ring::Entry, 2> incoming{};  // listener
  Ring ring;
  std::atomic<std::uint32_t> alive{0};
  std::atomic<std::uint32_t> refused_policy{0};
  std::atomic<std::uint64_t> responder{0};
  std::atomic<std::uint64_t> unknown_kinds{0};

  typename Ring::Entry entry{};  // participant
  std::uint64_t next = 0;        // number of the oldest message not yet taken
  std::uint64_t malformed = 0;
  std::uint64_t stale = 0;
  std::uint64_t overwritten = 0;
  std::optional<T> held;  // of `latest`

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
  return impl_->take_newest(message, header);
}

template <class T>
bool Reader<T>::take_fresh(T& message, Header& header, double max_age) {
  T newest;
  Header newest_header;
  if (!impl_->take_newest(newest, newest_header)) return false;
  if (!impl_->fresh(newest_header, max_age)) {
    ++impl_->stale;
    return false;
  }
  message = newest;
  header = newest_header;
  return true;
}

template <class T>
bool Reader<T>::latest(T& message) {
  T newest;
  Header header;
  if (impl_->take_newest(newest, header)) impl_->held = newest;
  if (!impl_->held) return false;
  message = *impl_->held;
  return true;
}

template <class T>
bool Reader<T>::peer_alive() const noexcept {
  return impl_->alive.load() > 0;
}

template <class T>
ReaderCounters Reader<T>::counters() const noexcept {
  return {impl_->malformed + impl_->unknown_kinds.load(), impl_->stale, impl_->overwritten};
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

}  // namespace mrroc::links
