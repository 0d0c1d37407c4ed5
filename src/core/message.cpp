#include "mrroc/message.hpp"

#include "mrroc/errors.hpp"

namespace mrroc {

const char* describe(FieldKind kind) noexcept {
  switch (kind) {
    case FieldKind::number:
      return "number";
    case FieldKind::integer:
      return "integer";
    case FieldKind::truth:
      return "truth";
    case FieldKind::text:
      return "text";
    case FieldKind::vector:
      return "vector";
    case FieldKind::joints:
      return "joints";
    case FieldKind::pose:
      return "pose";
  }
  return "unknown";
}

std::uint64_t MessageSchema::fingerprint() const noexcept {
  Fnv1a hash;
  detail::hash_field(hash, label, FieldKind::number, 0);
  for (const MessageFieldEntry& field : fields) detail::hash_field(hash, field.name, field.kind, field.size);
  return hash.value();
}

namespace detail {

void throw_wrong_parcel(const Message& parcel, const MessageSchema& wanted) {
  std::string text = "a message '" + std::string{parcel.label.view()} + "' of " + std::to_string(parcel.size) +
                     " bytes came where '" + wanted.label + "' was expected:";
  for (const MessageFieldEntry& field : wanted.fields) text += " " + field.name + " (" + describe(field.kind) + ")";
  if (wanted.label == parcel.label.view()) text += "; the two programs were built with different versions of it";
  throw NonFatalError(ErrorCode::invalid_argument, text);
}

}  // namespace detail

}  // namespace mrroc
