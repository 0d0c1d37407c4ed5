#include "links/ros2/publisher.hpp"

#include "links/ros2/node_impl.hpp"
#include "links/ros2/ros_names.hpp"

namespace mrroc::ros2 {

struct RawPublisher::Impl {
  links::Entity topic;
  links::Entity writer;
};

RawPublisher::RawPublisher(Node& node, const std::string& topic, std::string_view type, std::string_view type_hash,
                           Durability durability)
    : impl_(std::make_unique<Impl>()) {
  Node::Impl& own = *node.impl_;
  impl_->topic = create_cdr_topic(own.participant.get(), dds_topic(topic), dds_type(type));
  impl_->writer = own.create_writer(impl_->topic, own.qos(durability, type_hash).get(), topic);
}

RawPublisher::~RawPublisher() = default;
RawPublisher::RawPublisher(RawPublisher&&) noexcept = default;

bool RawPublisher::write(CdrBytes cdr) noexcept { return dds_write(impl_->writer.get(), &cdr) == DDS_RETCODE_OK; }

bool RawPublisher::is_received() const noexcept {
  dds_publication_matched_status_t status{};
  return dds_get_publication_matched_status(impl_->writer.get(), &status) == DDS_RETCODE_OK && status.current_count > 0;
}

}  // namespace mrroc::ros2
