#include "links/telemetry/status_publisher.hpp"

#include "links/transport/entity.hpp"
#include "links/transport/topic_name.hpp"
#include "links/wire/codec.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::links {

struct StatusPublisher::Impl {
  Wire<ProcessStatus> sample{};
  Entity topic;
  Entity writer;
};

StatusPublisher::StatusPublisher(Domain& domain, const std::string& deployment) : impl_(std::make_unique<Impl>()) {
  const std::string topic = topic_name(deployment, "process_status");
  impl_->topic = create_topic(domain, WireOf<ProcessStatus>::descriptor(), topic);
  impl_->writer =
      Entity{dds_create_writer(domain.participant(), impl_->topic.get(), status_writer_qos(domain).get(), nullptr),
             "writer", topic};
  impl_->sample.header.boot = domain.boot();
}

StatusPublisher::~StatusPublisher() = default;

void StatusPublisher::publish(const ProcessStatus& status) {
  encode(status, impl_->sample);
  ++impl_->sample.header.number;
  const dds_return_t code = dds_write(impl_->writer.get(), &impl_->sample);
  if (code != DDS_RETCODE_OK) {
    throw SystemError(ErrorCode::link_lost, std::string("process status: not written: ") + dds_strretcode(code));
  }
}

}  // namespace mrroc::links
