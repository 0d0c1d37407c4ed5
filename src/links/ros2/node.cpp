#include "links/ros2/node.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "links/cyclone/received_samples.hpp"
#include "links/cyclone/received_types.hpp"
#include "links/cyclone/socket_limit.hpp"
#include "links/ros2/node_impl.hpp"
#include "links/ros2/ros_names.hpp"
#include "links/transport/dds_log.hpp"
#include "links/transport/network_interface.hpp"
#include "messages/rmw_dds_common/participant_entities_info.hpp"
#include "messages/rmw_dds_common_humble/participant_entities_info.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::ros2 {
namespace {

constexpr int kLastDomain = 230;  // the ports of domain 231 end beyond 65535
constexpr std::int32_t kHistory = 10;
constexpr std::int32_t kLogHistory = 1000;  // as of rclcpp's /rosout
constexpr const char* kGraphTopic = "ros_discovery_info";
constexpr const char* kGraphType = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";

/// A loopback device takes no multicast: there, nodes are found by their index, as with ROS_LOCALHOST_ONLY.
std::string configuration_of(const std::optional<links::NetworkInterface>& interface) {
  std::string general;
  std::string discovery;
  if (interface) {
    const std::string multicast = interface->loopback ? " multicast=\"false\"" : "";
    general = "<General><Interfaces><NetworkInterface address=\"" + interface->address + "\"" + multicast +
              "/></Interfaces></General>";
    if (interface->loopback)
      discovery =
          "<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>"
          "<Peers><Peer Address=\"" +
          interface->address + "\"/></Peers></Discovery>";
  }
  std::string text = "<CycloneDDS><Domain Id=\"any\">" + general +
                     "<SharedMemory><Enable>false</Enable></SharedMemory>" + discovery +
                     // a subscriber that has died does not hold up the end
                     "<Internal><WriterLingerDuration>100ms</WriterLingerDuration></Internal></Domain></CycloneDDS>";
  const char* const own = std::getenv("CYCLONEDDS_URI");
  if (!interface && own != nullptr && *own != '\0') text.append(",").append(own);
  return text;
}

/// With the last words of Cyclone's log, which name a device, a port, or a mistake in the environment's CYCLONEDDS_URI.
[[noreturn]] void refuse(const std::string& what, int domain, dds_return_t code) {
  std::string text = "ROS 2 domain " + std::to_string(domain) + ": no " + what + ": " + dds_strretcode(code);
  if (const auto log = links::dds_log_messages(); !log.empty()) text += " (" + log.back() + ")";
  throw SystemError(ErrorCode::resources, text);
}

links::Entity create_domain(const NodeOptions& options, const std::optional<links::NetworkInterface>& interface) {
  links::install_dds_log();
  links::mend_received_samples();
  links::mend_received_types();
  const auto id = static_cast<dds_domainid_t>(options.domain);
  const dds_entity_t domain = dds_create_domain(id, configuration_of(interface).c_str());
  if (domain < 0) refuse("domain", options.domain, domain);
  return {domain, "", ""};
}

links::Entity create_participant(int domain) {
  const links::Qos qos{dds_create_qos()};
  constexpr std::string_view kEnclave = "enclave=/;";
  dds_qset_userdata(qos.get(), kEnclave.data(), kEnclave.size());
  const dds_entity_t participant = dds_create_participant(static_cast<dds_domainid_t>(domain), qos.get(), nullptr);
  if (participant < 0) refuse("participant", domain, participant);
  return {participant, "", ""};
}

template <class Gid>
Gid gid_of(dds_entity_t entity) {
  dds_guid_t guid{};
  dds_get_guid(entity, &guid);
  Gid gid{};
  std::copy(std::begin(guid.v), std::end(guid.v), gid.data.begin());
  return gid;
}

/// The list of a participant's nodes, which is this one. <Info, NodeInfo, Gid> of one distribution.
template <class Info, class NodeInfo, class Gid>
CdrBytes graph_of(const NodeOptions& options, dds_entity_t participant, const std::vector<dds_entity_t>& readers,
                  const std::vector<dds_entity_t>& writers) {
  NodeInfo own;
  own.node_namespace = options.node_namespace;
  own.node_name = options.node;
  for (const dds_entity_t each : readers) own.reader_gid_seq.push_back(gid_of<Gid>(each));
  for (const dds_entity_t each : writers) own.writer_gid_seq.push_back(gid_of<Gid>(each));
  Info info;
  info.gid = gid_of<Gid>(participant);
  info.node_entities_info_seq.push_back(std::move(own));
  return messages::to_cdr(info);
}

}  // namespace

Node::Impl::Impl(const NodeOptions& given) : options(given) {
  if (options.domain < 0 || options.domain > kLastDomain)
    throw SystemError(ErrorCode::configuration, "ROS 2 domain " + std::to_string(options.domain) + ": expected 0.." +
                                                    std::to_string(kLastDomain));
  std::optional<links::NetworkInterface> interface;
  if (!options.interface.empty()) interface = links::find_interface(options.interface);
  std::optional<links::SocketLimit> limit;
  if (interface) limit.emplace(*interface);
  domain = create_domain(options, interface);
  participant = create_participant(options.domain);
  graph_topic = create_cdr_topic(participant.get(), kGraphTopic, kGraphType);
  const links::Qos graph_qos = qos(Durability::last, messages::rmw_dds_common::ParticipantEntitiesInfo::kHash);
  graph = {dds_create_writer(participant.get(), graph_topic.get(), graph_qos.get(), nullptr), "writer", kGraphTopic};
}

links::Qos Node::Impl::qos(Durability durability, std::string_view type_hash, std::string_view identity) const {
  links::Qos qos{dds_create_qos()};
  const std::int32_t depth = durability == Durability::last  ? 1
                             : durability == Durability::log ? kLogHistory
                                                             : kHistory;
  dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_MSECS(100));
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, depth);
  if (durability == Durability::none) {
    dds_qset_durability(qos.get(), DDS_DURABILITY_VOLATILE);
  } else {
    dds_qset_durability(qos.get(), DDS_DURABILITY_TRANSIENT_LOCAL);
    dds_qset_durability_service(qos.get(), 0, DDS_HISTORY_KEEP_LAST, depth, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED,
                                DDS_LENGTH_UNLIMITED);
  }
  if (durability == Durability::log) dds_qset_lifespan(qos.get(), DDS_SECS(10));
  dds_qset_writer_data_lifecycle(qos.get(), false);
  std::string user_data(identity);
  if (options.distro != Distro::humble && !type_hash.empty()) user_data += "typehash=" + std::string(type_hash) + ";";
  if (!user_data.empty()) dds_qset_userdata(qos.get(), user_data.data(), user_data.size());
  return qos;
}

links::Entity Node::Impl::create_writer(const links::Entity& topic, const dds_qos_t* qos, const std::string& name) {
  links::Entity writer{dds_create_writer(participant.get(), topic.get(), qos, nullptr), "writer", name};
  writers.push_back(writer.get());
  return writer;
}

links::Entity Node::Impl::create_reader(const links::Entity& topic, const dds_qos_t* qos, const std::string& name) {
  links::Entity reader{dds_create_reader(participant.get(), topic.get(), qos, nullptr), "reader", name};
  readers.push_back(reader.get());
  return reader;
}

void Node::Impl::announce() {
  using namespace messages;
  const auto of_humble = &graph_of<rmw_dds_common_humble::ParticipantEntitiesInfo,
                                   rmw_dds_common_humble::NodeEntitiesInfo, rmw_dds_common_humble::Gid>;
  const auto of_iron =
      &graph_of<rmw_dds_common::ParticipantEntitiesInfo, rmw_dds_common::NodeEntitiesInfo, rmw_dds_common::Gid>;
  const auto graph_of_distro = options.distro == Distro::humble ? of_humble : of_iron;
  const CdrBytes info = graph_of_distro(options, participant.get(), readers, writers);
  const dds_return_t code = dds_write(graph.get(), &info);
  if (code != DDS_RETCODE_OK)
    throw SystemError(ErrorCode::link_lost, std::string(kGraphTopic) + ": not written: " + dds_strretcode(code));
}

Node::Node(const NodeOptions& options) : impl_(std::make_unique<Impl>(options)) {}
Node::~Node() = default;

void Node::announce() { impl_->announce(); }

}  // namespace mrroc::ros2
