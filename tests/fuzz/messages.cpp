// The decoder of every IDL type: the first byte selects the type, the rest is the received data. It passes through
// Cyclone's own deserialiser, like a received sample (with the top bit of the first byte set it is the wire struct
// itself), then through the framework's decoder.
#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>

#include <array>
#include <memory>
#include <optional>

#include "fuzz/fuzz.hpp"
#include "links/test_domain.hpp"
#include "links/transport/domain.hpp"
#include "links/wire/codec.hpp"
#include "mrroc/message.hpp"

namespace fuzz {

/// A message with a field of every kind that a message may contain.
struct Everything {
  double number = 0;
  int integer = 0;
  bool truth = false;
  mrroc::FixedText<15> text;
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  mrroc::JointVector joints;
  mrroc::Pose pose = mrroc::Pose::Identity();
};
MRROC_MESSAGE(Everything, number, integer, truth, text, vector, joints, pose)

namespace {

using namespace mrroc::links;

/// Uses of a message that was accepted.
template <class T>
void use(const T&) {}

void use(const mrroc::Message& parcel) {
  refuses<mrroc::NonFatalError>([&] { mrroc::unpack<Everything>(parcel); });
  mrroc::Message forged = parcel;  // a fingerprint is not secret
  forged.fingerprint = mrroc::detail::fingerprint_of<Everything>();
  forged.size = static_cast<std::uint16_t>(mrroc::detail::size_of<Everything>());
  const auto message = mrroc::unpack<Everything>(forged);
  require(message.joints.size() <= mrroc::kMaxJoints, "at most kMaxJoints joints");
}

void use(const TaskCommand& command) { use(command.parcel); }
void use(const TaskStatus& status) { use(status.parcel); }

/// Decodes the wire struct. An accepted message is sent and accepted again, unchanged.
template <class T>
void decode_wire(const Wire<T>& wire) {
  T message;
  if (!decode(wire, message)) return;
  use(message);
  Wire<T> first{};
  encode(message, first);
  T again;
  require(decode(first, again), "a decoded message can be sent on");
  Wire<T> second{};
  encode(again, second);
  require(std::memcmp(&first, &second, sizeof first) == 0, "a message sent on is unchanged");
}

class Type {
 public:
  virtual ~Type() = default;
  virtual void network(std::string_view bytes) const = 0;
  virtual void memory(std::string_view bytes) const = 0;
};

template <class T>
class TypeOf final : public Type {
 public:
  TypeOf(mrroc::links::Domain& domain, const char* name) {
    const dds_entity_t topic = dds_create_topic(domain.participant(), &WireOf<T>::descriptor(), name, nullptr, nullptr);
    const dds_entity_t reader = dds_create_reader(domain.participant(), topic, nullptr, nullptr);
    const dds_entity_t writer = dds_create_writer(domain.participant(), topic, nullptr, nullptr);
    const Wire<T> sample{};
    dds_sample_info_t info;
    // only a sample contains Cyclone's form of the type
    require(
        writer > 0 && dds_write(writer, &sample) == 0 && dds_takecdr(reader, &sample_, 1, &info, DDS_ANY_STATE) == 1,
        "a topic of this type works");
    dds_delete(writer);
    dds_delete(reader);
  }
  ~TypeOf() override { ddsi_serdata_unref(sample_); }

  void network(std::string_view bytes) const override {
    ddsrt_iovec_t part{};
    part.iov_base = const_cast<char*>(bytes.data());
    part.iov_len = bytes.size();
    ddsi_serdata* received = ddsi_serdata_from_ser_iov(sample_->type, SDK_DATA, 1, &part, bytes.size());
    if (received == nullptr) return;
    const auto wire = std::make_unique<Wire<T>>();
    const bool made = ddsi_serdata_to_sample(received, wire.get(), nullptr, nullptr);
    ddsi_serdata_unref(received);
    if (made) decode_wire<T>(*wire);
  }

  void memory(std::string_view bytes) const override {
    const auto wire = std::make_unique<Wire<T>>();
    std::memcpy(wire.get(), bytes.data(), std::min(bytes.size(), sizeof *wire));
    decode_wire<T>(*wire);
  }

 private:
  ddsi_serdata* sample_ = nullptr;
};

struct Types {
  TestDomain domain;
  std::array<std::unique_ptr<Type>, 11> all{
      std::make_unique<TypeOf<mrroc::RobotCommand>>(domain.domain, "robot_command"),
      std::make_unique<TypeOf<mrroc::RobotState>>(domain.domain, "robot_state"),
      std::make_unique<TypeOf<mrroc::SensorRequest>>(domain.domain, "sensor_request"),
      std::make_unique<TypeOf<mrroc::SensorReading>>(domain.domain, "sensor_reading"),
      std::make_unique<TypeOf<TaskCommand>>(domain.domain, "task_command"),
      std::make_unique<TypeOf<TaskStatus>>(domain.domain, "task_status"),
      std::make_unique<TypeOf<OperatorQuestion>>(domain.domain, "operator_question"),
      std::make_unique<TypeOf<OperatorAnswer>>(domain.domain, "operator_answer"),
      std::make_unique<TypeOf<mrroc::TrajectoryPart>>(domain.domain, "trajectory_part"),
      std::make_unique<TypeOf<mrroc::TrajectoryReport>>(domain.domain, "trajectory_report"),
      std::make_unique<TypeOf<ProcessStatus>>(domain.domain, "process_status"),
  };
};

}  // namespace
}  // namespace fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Types types;
  fuzz::Bytes input(data, size);
  const auto kind = input.take<std::uint8_t>();
  const fuzz::Type& type = *types.all[(kind & 0x7f) % types.all.size()];
  if ((kind & 0x80) != 0)
    type.memory(input.rest());
  else
    type.network(input.rest());
  return 0;
}
