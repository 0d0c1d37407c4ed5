#pragma once

// internal to src/links: includes dds.h

#include <vector>

#include "links/ros2/cdr_type.hpp"
#include "links/ros2/node.hpp"
#include "links/transport/entity.hpp"

namespace mrroc::ros2 {

/// What the endpoints of a node use of it.
struct Node::Impl {
  explicit Impl(const NodeOptions& options);

  /// QoS of ROS 2's default profile, or of one that keeps the last message. The texts become the endpoint's user data;
  /// empty ones are left out.
  links::Qos qos(Durability durability, std::string_view type_hash, std::string_view identity = {}) const;
  links::Entity create_writer(const links::Entity& topic, const dds_qos_t* qos, const std::string& name);
  /// The reader wakes no thread: it is polled.
  links::Entity create_reader(const links::Entity& topic, const dds_qos_t* qos, const std::string& name);
  void announce();

  NodeOptions options;
  links::Entity domain;
  links::Entity participant;
  std::vector<dds_entity_t> writers, readers;  // that other nodes see
  links::Entity graph_topic;
  links::Entity graph;
};

}  // namespace mrroc::ros2
