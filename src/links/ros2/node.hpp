#pragma once

#include <memory>
#include <string>

namespace mrroc::ros2 {

/// What the releases of ROS 2 have different on the wire.
enum class Distro {
  humble,  ///< identities of 24 bytes in the list of nodes, no type hashes
  iron,    ///< and Jazzy: identities of 16 bytes, type hashes
  kilted,  ///< and later: as Iron, with indices in the feedback of FollowJointTrajectory
};

struct NodeOptions {
  int domain = 0;  ///< ROS_DOMAIN_ID, 0..230
  Distro distro = Distro::iron;
  std::string node;  ///< its name, as of `ros_name`
  std::string node_namespace = "/";
  /// Network device or own address whose packets alone are received; empty: as Cyclone DDS chooses for any ROS 2 node,
  /// with the environment's CYCLONEDDS_URI.
  std::string interface = {};
};

/// What a late subscriber receives: nothing that was before, the last message, or, of log lines, those of 10 s.
enum class Durability { none, last, log };

/// A node of ROS 2 without ROS 2: a DDS participant that other nodes find, and that `ros2 node list` shows. DDS as
/// rmw_cyclonedds does it; what is verified and what is not: docs/how-to/ros2.md. One per process. One thread.
class Node {
 public:
  /// Throws SystemError: a domain, an interface (configuration), an error of DDS, such as a mistake in CYCLONEDDS_URI
  /// (resources).
  explicit Node(const NodeOptions& options);
  ~Node();
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  /// Makes the node with its present endpoints known; again after further ones. Throws SystemError (link_lost).
  void announce();

 private:
  friend class RawPublisher;
  friend class RawService;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mrroc::ros2
