#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <thread>

#include "links/ros2/cdr_type.hpp"
#include "links/ros2/ros_names.hpp"
#include "messages/cdr_reader.hpp"
#include "messages/cdr_writer.hpp"

namespace mrroc::ros2 {

/// Calls `poll` until it returns something; nothing after 10 s.
template <class Poll>
auto wait_for(Poll poll) -> decltype(poll()) {
  for (int look = 0; look < 5000; ++look) {
    if (auto found = poll()) return found;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return {};
}

/// A reader of one topic, in a participant of its own.
template <class Message>
class TestReader {
 public:
  TestReader(dds_entity_t participant, const std::string& topic, const std::string& type, bool last = false)
      : topic_(create_cdr_topic(participant, topic, dds_type(type))) {
    const links::Qos qos{dds_create_qos()};
    dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
    dds_qset_history(qos.get(), DDS_HISTORY_KEEP_ALL, 0);
    if (last) dds_qset_durability(qos.get(), DDS_DURABILITY_TRANSIENT_LOCAL);
    reader_ = {dds_create_reader(participant, topic_.get(), qos.get(), nullptr), "reader", topic};
  }

  /// The next message, or nothing. Does not wait.
  std::optional<Message> take() {
    CdrBytes bytes;
    dds_sample_info_t info;
    void* samples[] = {&bytes};
    while (dds_take(reader_.get(), samples, &info, 1, 1) == 1)
      if (info.valid_data) return messages::from_cdr<Message>(bytes);
    return std::nullopt;
  }

 private:
  links::Entity topic_, reader_;
};

/// A client of one service, which numbers its requests.
template <class Request, class Reply>
class TestClient {
 public:
  /// `id`: the client's identity.
  TestClient(dds_entity_t participant, const std::string& service, const std::string& type, std::uint64_t id)
      : topic_(create_cdr_topic(participant, dds_request_topic(service), dds_type(type + "_Request"))),
        replies_(participant, dds_reply_topic(service), type + "_Response"),
        id_(id) {
    const links::Qos qos{dds_create_qos()};
    dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
    writer_ = {dds_create_writer(participant, topic_.get(), qos.get(), nullptr), "writer", service};
  }

  std::int64_t send(Request request) {
    request.client = id_;
    request.sequence = ++last_;
    write(messages::to_cdr(request));
    return last_;
  }
  void write(const CdrBytes& bytes) { dds_write(writer_.get(), &bytes); }
  /// The next reply to this client, or nothing. Does not wait.
  std::optional<Reply> take() {
    while (auto reply = replies_.take())
      if (reply->client == id_) return reply;
    return std::nullopt;
  }

 private:
  links::Entity topic_, writer_;
  TestReader<Reply> replies_;
  std::uint64_t id_;
  std::int64_t last_ = 0;
};

}  // namespace mrroc::ros2
