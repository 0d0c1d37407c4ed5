// A node of ROS 2 in this process. What other implementations see of it: tests/system/ros2_test.py.
#include "links/ros2/node.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <thread>

#include "links/cyclone/socket_limit.hpp"
#include "links/ros2/cdr_type.hpp"
#include "links/ros2/publisher.hpp"
#include "links/ros2/service.hpp"
#include "links/transport/descriptors.hpp"
#include "messages/std_msgs/string.hpp"
#include "messages/std_srvs_cyclone/trigger_reply.hpp"
#include "messages/std_srvs_cyclone/trigger_request.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::ros2::node_test {
namespace {

using messages::std_msgs::String;
using Request = messages::std_srvs_cyclone::TriggerRequest;
using Reply = messages::std_srvs_cyclone::TriggerReply;

constexpr int kDomain = 201;

NodeOptions local(const std::string& interface = "lo") {
  return {.domain = kDomain, .node = "mrroc_test", .interface = interface};
}

/// A peer in a participant of its own.
struct Peer {
  links::Entity participant{dds_create_participant(kDomain, nullptr, nullptr), "participant", ""};

  links::Entity reader(const links::Entity& topic) const {
    const links::Qos qos{dds_create_qos()};
    dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
    dds_qset_durability(qos.get(), DDS_DURABILITY_TRANSIENT_LOCAL);
    return {dds_create_reader(participant.get(), topic.get(), qos.get(), nullptr), "reader", ""};
  }
};

/// The next sample within a number of looks; empty without one.
CdrBytes take(const links::Entity& reader) {
  CdrBytes bytes;
  dds_sample_info_t info;
  void* samples[] = {&bytes};
  for (int look = 0; look < 5000; ++look) {
    if (dds_take(reader.get(), samples, &info, 1, 1) == 1 && info.valid_data) return bytes;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return {};
}

TEST(Node, LateSubscribersGetTheLastMessageOfAnySize) {
  Node node(local());
  Publisher<String> publisher(node, "/text", Durability::last);
  const Peer peer;
  const links::Entity topic = create_cdr_topic(peer.participant.get(), "rt/text", "std_msgs::msg::dds_::String_");
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{70000}, std::size_t{3000000}}) {
    String message;
    message.data.assign(size, 'x');
    EXPECT_TRUE(publisher.publish(message));
    const links::Entity reader = peer.reader(topic);
    EXPECT_EQ(messages::from_cdr<String>(take(reader)), message) << size;
  }
}

TEST(Node, AServiceAnswersTheCallerAndRefusesWhatIsNoRequest) {
  Node node(local());
  Service<Request, Reply> service(node, "/mrroc/start", "std_srvs/srv/Trigger");
  const Peer peer;
  const auto topic_of = [&](const char* name, const char* type) {
    return create_cdr_topic(peer.participant.get(), name, type);
  };
  const links::Entity requests = topic_of("rq/mrroc/startRequest", "std_srvs::srv::dds_::Trigger_Request_");
  const links::Entity replies = topic_of("rr/mrroc/startReply", "std_srvs::srv::dds_::Trigger_Response_");
  const links::Qos qos{dds_create_qos()};
  dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
  const links::Entity writer{dds_create_writer(peer.participant.get(), requests.get(), qos.get(), nullptr), "writer",
                             ""};
  const links::Entity reader{dds_create_reader(peer.participant.get(), replies.get(), qos.get(), nullptr), "reader",
                             ""};
  Request request;
  request.client = 0x1122334455667788;
  request.sequence = 42;
  CdrBytes cut = messages::to_cdr(request);
  cut.resize(12);
  for (const CdrBytes& bytes : {CdrBytes{}, cut, messages::to_cdr(request)})
    ASSERT_EQ(dds_write(writer.get(), &bytes), DDS_RETCODE_OK);
  std::optional<Request> taken;
  for (int look = 0; look < 5000 && !taken; ++look) {
    taken = service.take();
    if (!taken) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_EQ(taken, request);
  EXPECT_EQ(service.malformed(), 2u);
  Reply reply;
  reply.success = true;
  reply.message = "started";
  service.reply(*taken, reply);
  const auto received = messages::from_cdr<Reply>(take(reader));
  EXPECT_EQ(received.client, request.client);
  EXPECT_EQ(received.sequence, request.sequence);
  EXPECT_EQ(received.message, "started");
}

TEST(Node, AClientThatEndsLeavesNoRequest) {
  Node node(local());
  Service<Request, Reply> service(node, "/mrroc/start", "std_srvs/srv/Trigger");
  const Peer peer;
  const links::Entity topic =
      create_cdr_topic(peer.participant.get(), "rq/mrroc/startRequest", "std_srvs::srv::dds_::Trigger_Request_");
  for (int client = 0; client < 20; ++client) {
    const links::Qos qos{dds_create_qos()};
    dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
    links::Entity writer{dds_create_writer(peer.participant.get(), topic.get(), qos.get(), nullptr), "writer", ""};
    const CdrBytes bytes = messages::to_cdr(Request{.client = 7, .sequence = client});
    ASSERT_EQ(dds_write(writer.get(), &bytes), DDS_RETCODE_OK);
    if (client % 2 == 0) {
      EXPECT_TRUE(service.take()) << client;
    }
    ASSERT_EQ(dds_dispose(writer.get(), &bytes), DDS_RETCODE_OK);
    writer.reset();
    EXPECT_EQ(service.take().has_value(), client % 2 == 1) << client;
    EXPECT_FALSE(service.take()) << client;
  }
  EXPECT_EQ(service.malformed(), 0u);
}

TEST(Node, ReceivesFromTheInterfaceThatIsNamedAlone) {
  const auto before = links::open_descriptors();
  const Node node(local());
  int sockets = 0;
  for (const int fd : links::open_descriptors()) {
    if (before.contains(fd) || !links::is_udp_socket(fd)) continue;
    ++sockets;
    EXPECT_TRUE(links::is_limited(fd)) << fd;
  }
  EXPECT_GT(sockets, 1);
}

TEST(Node, NamesAMistakeInTheEnvironment) {
  setenv("CYCLONEDDS_URI", "<General><NoSuchElement/></General>", 1);
  try {
    const Node node(local(""));
    ADD_FAILURE() << "accepted";
  } catch (const SystemError& error) {
    EXPECT_EQ(error.code(), ErrorCode::resources);
    EXPECT_NE(std::string(error.what()).find("NoSuchElement"), std::string::npos) << error.what();
  }
  EXPECT_NO_THROW(Node{local()}) << "with an interface the environment is not read";
  unsetenv("CYCLONEDDS_URI");
}

TEST(Node, RefusesADomainAndAnInterfaceThatAreNone) {
  NodeOptions options = local();
  for (const int domain : {-1, 231}) {
    options.domain = domain;
    EXPECT_THROW(Node{options}, SystemError) << domain;
  }
  EXPECT_THROW(Node{local("nowhere0")}, SystemError);
}

}  // namespace
}  // namespace mrroc::ros2::node_test
