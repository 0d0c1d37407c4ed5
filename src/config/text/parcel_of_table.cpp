#include "config/text/parcel_of_table.hpp"

#include <algorithm>
#include <limits>

#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

template <class T>
void put(const T& value, std::uint8_t* bytes) {
  FieldOf<T>::put(value, bytes);
}

std::vector<double> numbers_of(const Table& table, const MessageFieldEntry& field) {
  const std::size_t count = field.kind == FieldKind::pose     ? 6
                            : field.kind == FieldKind::vector ? field.size / sizeof(double)
                                                              : 0;
  std::vector<double> values = table.numbers(field.name, count);
  if (field.kind == FieldKind::joints && values.size() > static_cast<std::size_t>(kMaxJoints))
    table.fail(field.name, std::to_string(values.size()) + " joints", "at most " + std::to_string(kMaxJoints));
  return values;
}

std::string text_of(const Table& table, const MessageFieldEntry& field) {
  std::string text = table.text(field.name);
  if (text.size() >= field.size)
    table.fail(field.name, in_quotes(text), "a text of at most " + std::to_string(field.size - 1) + " characters");
  return text;
}

Pose pose_of(const std::vector<double>& v) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  Pose pose = Pose::Identity();
  pose.translation() = Vector3d(v[0], v[1], v[2]);
  pose.linear() =
      (AngleAxisd(v[5], Vector3d::UnitZ()) * AngleAxisd(v[4], Vector3d::UnitY()) * AngleAxisd(v[3], Vector3d::UnitX()))
          .toRotationMatrix();
  return pose;
}

void put_field(const Table& table, const MessageFieldEntry& field, std::uint8_t* bytes) {
  constexpr auto kMin = std::numeric_limits<std::int64_t>::min(), kMax = std::numeric_limits<std::int64_t>::max();
  switch (field.kind) {
    case FieldKind::number:
      return put(table.number(field.name), bytes);
    case FieldKind::integer:
      return put(table.integer(field.name, kMin, kMax), bytes);
    case FieldKind::truth:
      if (!table.has(field.name)) table.fail(field.name, "is missing", "true or false");
      return put(table.boolean_or(field.name, false), bytes);
    case FieldKind::text: {
      const std::string text = text_of(table, field);
      std::copy(text.begin(), text.end(), bytes);
      return;
    }
    case FieldKind::vector: {
      const std::vector<double> values = numbers_of(table, field);
      std::memcpy(bytes, values.data(), field.size);
      return;
    }
    case FieldKind::joints: {
      const std::vector<double> values = numbers_of(table, field);
      return put(JointVector(Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values))), bytes);
    }
    case FieldKind::pose:
      return put(pose_of(numbers_of(table, field)), bytes);
  }
}

}  // namespace

Message parcel_of(const Table& table, const MessageSchema& schema) {
  Message parcel;
  parcel.label.assign(schema.label);
  parcel.fingerprint = schema.fingerprint();
  for (const MessageFieldEntry& field : schema.fields) {
    put_field(table, field, parcel.content.data() + parcel.size);
    parcel.size = static_cast<std::uint16_t>(parcel.size + field.size);
  }
  return parcel;
}

std::string arguments_text(const Table& table, const MessageSchema& schema) {
  std::string text;
  for (const MessageFieldEntry& field : schema.fields) {
    text += (text.empty() ? "" : ", ") + field.name + " = ";
    switch (field.kind) {
      case FieldKind::number:
        text += number_text(table.number(field.name));
        break;
      case FieldKind::integer:
        text += std::to_string(table.integer(field.name, std::numeric_limits<std::int64_t>::min(),
                                             std::numeric_limits<std::int64_t>::max()));
        break;
      case FieldKind::truth:
        text += table.boolean_or(field.name, false) ? "true" : "false";
        break;
      case FieldKind::text:
        text += in_quotes(table.text(field.name));
        break;
      default: {
        std::string list;
        for (const double value : table.numbers(field.name)) list += (list.empty() ? "" : ", ") + number_text(value);
        text += "[" + list + "]";
      }
    }
  }
  return text;
}

}  // namespace mrroc::config
