#include "links/ros2/service.hpp"

#include <sys/random.h>

#include <array>
#include <cstdio>

#include "links/ros2/node_impl.hpp"
#include "links/ros2/ros_names.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::ros2 {
namespace {

/// By which a client sees that the reader of requests and the writer of replies are one service: any 16 bytes that no
/// other service has.
std::string new_identity() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != std::ssize(bytes))
    throw SystemError(ErrorCode::resources, "no random number");
  std::string text = "serviceid=";
  for (const unsigned byte : bytes) {
    char digits[4];
    std::snprintf(digits, sizeof digits, "%x.", byte);
    text += digits;
  }
  text.back() = ';';
  return text;
}

}  // namespace

struct RawService::Impl {
  links::Entity request_topic, reply_topic;
  links::Entity reader, writer;
};

RawService::RawService(Node& node, const std::string& name, const std::string& type) : impl_(std::make_unique<Impl>()) {
  Node::Impl& own = *node.impl_;
  const dds_entity_t participant = own.participant.get();
  impl_->request_topic = create_cdr_topic(participant, dds_request_topic(name), dds_type(type + "_Request"));
  impl_->reply_topic = create_cdr_topic(participant, dds_reply_topic(name), dds_type(type + "_Response"));
  const links::Qos qos = own.qos(Durability::none, "", new_identity());
  impl_->reader = own.create_reader(impl_->request_topic, qos.get(), name);
  impl_->writer = own.create_writer(impl_->reply_topic, qos.get(), name);
}

RawService::~RawService() = default;
RawService::RawService(RawService&&) noexcept = default;

std::optional<CdrBytes> RawService::take() {
  CdrBytes bytes;
  dds_sample_info_t info;
  void* samples[] = {&bytes};
  while (dds_take(impl_->reader.get(), samples, &info, 1, 1) == 1)
    if (info.valid_data) return bytes;
  return std::nullopt;
}

void RawService::reply(CdrBytes cdr) noexcept { dds_write(impl_->writer.get(), &cdr); }

}  // namespace mrroc::ros2
