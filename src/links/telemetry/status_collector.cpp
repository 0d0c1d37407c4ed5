#include "links/telemetry/status_collector.hpp"

#include <cstring>

#include "links/transport/entity.hpp"
#include "links/transport/topic_name.hpp"
#include "links/wire/codec.hpp"

namespace mrroc::links {

struct StatusCollector::Impl {
  Wire<ProcessStatus> sample{};
  Entity topic;
  Entity reader;
};

StatusCollector::StatusCollector(Domain& domain, const std::string& deployment) : impl_(std::make_unique<Impl>()) {
  const std::string topic = topic_name(deployment, "process_status");
  impl_->topic = create_topic(domain, WireOf<ProcessStatus>::descriptor(), topic);
  impl_->reader = Entity{
      dds_create_reader(domain.participant(), impl_->topic.get(), status_reader_qos().get(), nullptr), "reader", topic};
}

StatusCollector::~StatusCollector() = default;

void StatusCollector::poll() {
  Wire<ProcessStatus>& sample = impl_->sample;
  dds_sample_info_t info;
  void* samples[] = {&sample};
  while (dds_take(impl_->reader.get(), samples, &info, 1, 1) == 1) {
    if (info.valid_data) {
      ProcessStatus status;
      if (!decode(sample, status)) {
        ++malformed_;
        continue;
      }
      processes_[std::string(status.process.view())].status = status;
    }
    // the key is valid even in a sample that only reports the loss of its writer
    const std::string name(sample.process, ::strnlen(sample.process, sizeof sample.process));
    const auto process = processes_.find(name);
    if (process != processes_.end()) process->second.alive = info.instance_state == DDS_ALIVE_INSTANCE_STATE;
  }
}

}  // namespace mrroc::links
