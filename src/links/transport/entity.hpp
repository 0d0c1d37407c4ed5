#pragma once

// internal to src/links: includes dds.h

#include <dds/dds.h>

#include <memory>
#include <string_view>
#include <utility>

#include "links/transport/domain.hpp"

namespace mrroc::links {

/// Owns one DDS entity.
class Entity {
 public:
  Entity() = default;
  /// Throws SystemError (resources) naming the topic when `handle` is an error code.
  Entity(dds_entity_t handle, std::string_view what, std::string_view topic);
  ~Entity() { reset(); }
  Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  Entity& operator=(Entity&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  dds_entity_t get() const noexcept { return handle_; }
  /// Deletes it; returns when no listener of it runs any more.
  void reset() noexcept {
    if (handle_ > 0) dds_delete(std::exchange(handle_, 0));
  }

 private:
  dds_entity_t handle_ = 0;
};

struct QosDeleter {
  void operator()(dds_qos_t* qos) const noexcept { dds_delete_qos(qos); }
};
struct ListenerDeleter {
  void operator()(dds_listener_t* listener) const noexcept { dds_delete_listener(listener); }
};
using Qos = std::unique_ptr<dds_qos_t, QosDeleter>;
using Listener = std::unique_ptr<dds_listener_t, ListenerDeleter>;

// The writer's lease applies; readers request no lease, so that the two always match.

/// Of every link: reliable, volatile, a few messages kept for retransmission, liveliness by the domain's lease.
/// latency_budget is never set: above 0 it loses messages in lockstep.
Qos link_writer_qos(const Domain& domain);
Qos link_reader_qos();

/// Of telemetry: the newest sample of each process is kept for later readers.
Qos status_writer_qos(const Domain& domain);
Qos status_reader_qos();

/// Of states for watchers: best effort, the newest only.
Qos telemetry_qos();

Entity create_topic(const Domain& domain, const dds_topic_descriptor_t& type, const std::string& topic);

}  // namespace mrroc::links
