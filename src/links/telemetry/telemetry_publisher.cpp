#include "links/telemetry/telemetry_publisher.hpp"

#include <atomic>

#include "core/lockfree/shared_slot.hpp"
#include "links/transport/entity.hpp"
#include "links/wire/codec.hpp"

namespace mrroc::links {

template <class T>
struct TelemetryPublisher<T>::Impl {
  core::SharedSlot<Wire<T>> slot;
  Wire<T> stored{};  // the storing thread's
  Wire<T> sample{};  // the publishing thread's
  std::uint64_t published = 0;
  std::atomic<bool> wanted{false};
  Entity topic;
  Entity writer;
};

template <class T>
TelemetryPublisher<T>::TelemetryPublisher(Domain& domain, const std::string& topic) : impl_(std::make_unique<Impl>()) {
  impl_->topic = create_topic(domain, WireOf<T>::descriptor(), topic);
  impl_->writer = Entity{dds_create_writer(domain.participant(), impl_->topic.get(), telemetry_qos().get(), nullptr),
                         "writer", topic};
}

template <class T>
TelemetryPublisher<T>::~TelemetryPublisher() = default;

template <class T>
bool TelemetryPublisher<T>::wanted() const noexcept {
  return impl_->wanted.load(std::memory_order_relaxed);
}

template <class T>
void TelemetryPublisher<T>::store(const T& message) noexcept {
  encode(message, impl_->stored);
  ++impl_->stored.header.number;
  impl_->slot.store(impl_->stored);
}

template <class T>
void TelemetryPublisher<T>::publish() noexcept {
  dds_publication_matched_status_t matched{};
  dds_get_publication_matched_status(impl_->writer.get(), &matched);
  const bool wanted = matched.current_count > 0;
  const bool before = impl_->wanted.exchange(wanted, std::memory_order_relaxed);
  if (!wanted || !impl_->slot.load(impl_->sample)) return;
  // what was stored for the last watcher is old
  if (!before) impl_->published = impl_->sample.header.number;
  if (impl_->sample.header.number == impl_->published) return;
  impl_->published = impl_->sample.header.number;
  dds_write(impl_->writer.get(), &impl_->sample);  // a lost one is followed by a newer one
}

template class TelemetryPublisher<RobotState>;
template class TelemetryPublisher<SensorReading>;

}  // namespace mrroc::links
