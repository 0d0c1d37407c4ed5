#pragma once

// internal to src/links: includes dds.h

#include <cstddef>
#include <string>
#include <vector>

#include "links/transport/entity.hpp"

namespace mrroc::ros2 {

/// A sample of every topic of `create_cdr_topic`: a message in CDR with its header of 4 bytes.
using CdrBytes = std::vector<std::byte>;

/// A keyless topic whose samples are `CdrBytes` for dds_write and dds_take: no description of the type is compiled, and
/// Cyclone does not look into a message. Whoever takes one decodes it, and refuses it there.
/// Received messages of more than 4 MiB are dropped. Any thread.
///
/// `type`: its name on DDS. Throws SystemError (resources).
links::Entity create_cdr_topic(dds_entity_t participant, const std::string& topic, const std::string& type);

}  // namespace mrroc::ros2
