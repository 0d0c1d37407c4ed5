#include "links/transport/entity.hpp"

#include <string>

#include "links/transport/topic_name.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

constexpr std::int32_t kHistory = 16;

dds_duration_t nanoseconds(double seconds) {
  return seconds > 0 ? static_cast<dds_duration_t>(seconds * 1e9) : DDS_INFINITY;
}

Qos reliable_qos(dds_duration_t lease) {
  Qos qos{dds_create_qos()};
  dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_MSECS(5));
  dds_qset_liveliness(qos.get(), DDS_LIVELINESS_AUTOMATIC, lease);
  return qos;
}

Qos link_qos(dds_duration_t lease) {
  Qos qos = reliable_qos(lease);
  dds_qset_durability(qos.get(), DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, kHistory);
  return qos;
}

Qos status_qos(dds_duration_t lease) {
  Qos qos = reliable_qos(lease);
  dds_qset_durability(qos.get(), DDS_DURABILITY_TRANSIENT_LOCAL);
  dds_qset_durability_service(qos.get(), 0, DDS_HISTORY_KEEP_LAST, 1, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED,
                              DDS_LENGTH_UNLIMITED);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, 1);
  dds_qset_writer_data_lifecycle(qos.get(), false);  // the last message of a process that ends remains
  return qos;
}

}  // namespace

Entity::Entity(dds_entity_t handle, std::string_view what, std::string_view topic) : handle_(handle) {
  if (handle > 0) return;
  throw SystemError(ErrorCode::resources,
                    "DDS " + std::string(what) + " of topic " + std::string(topic) + ": " + dds_strretcode(handle));
}

Qos link_writer_qos(const Domain& domain) { return link_qos(nanoseconds(domain.lease())); }
Qos link_reader_qos() { return link_qos(DDS_INFINITY); }
Qos status_writer_qos(const Domain& domain) { return status_qos(nanoseconds(domain.lease())); }
Qos status_reader_qos() { return status_qos(DDS_INFINITY); }

Qos telemetry_qos() {
  Qos qos{dds_create_qos()};
  dds_qset_reliability(qos.get(), DDS_RELIABILITY_BEST_EFFORT, 0);
  dds_qset_durability(qos.get(), DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, 1);
  return qos;
}

Entity create_topic(const Domain& domain, const dds_topic_descriptor_t& type, const std::string& topic) {
  check_topic_name(topic);
  return Entity{dds_create_topic(domain.participant(), &type, topic.c_str(), nullptr, nullptr), "topic", topic};
}

}  // namespace mrroc::links
