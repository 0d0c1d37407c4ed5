#include "links/telemetry/telemetry_reader.hpp"

#include "links/transport/entity.hpp"
#include "links/wire/codec.hpp"

namespace mrroc::links {

template <class T>
struct TelemetryReader<T>::Impl {
  Wire<T> sample{};
  Entity topic;
  Entity reader;
};

template <class T>
TelemetryReader<T>::TelemetryReader(Domain& domain, const std::string& topic) : impl_(std::make_unique<Impl>()) {
  impl_->topic = create_topic(domain, WireOf<T>::descriptor(), topic);
  impl_->reader = Entity{dds_create_reader(domain.participant(), impl_->topic.get(), telemetry_qos().get(), nullptr),
                         "reader", topic};
}

template <class T>
TelemetryReader<T>::~TelemetryReader() = default;

template <class T>
bool TelemetryReader<T>::take(T& message) {
  dds_sample_info_t info;
  void* samples[] = {&impl_->sample};
  bool taken = false;
  while (dds_take(impl_->reader.get(), samples, &info, 1, 1) == 1)
    if (info.valid_data) taken = decode(impl_->sample, message) || taken;
  return taken;
}

template class TelemetryReader<RobotState>;
template class TelemetryReader<SensorReading>;

}  // namespace mrroc::links
