#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mrroc/fnv.hpp"
#include "mrroc/message_field.hpp"
#include "mrroc/parcel.hpp"

/// Makes a struct a message: an MP may start a behaviour of an ECP with it, and the two may send it to each other.
/// Place it below the struct, in its namespace, in a header that both programs include, and name every field in order:
///
///   struct Pick {
///     double x = 0, y = 0;  // m
///   };
///   MRROC_MESSAGE(Pick, x, y)
///
/// Fields are of the types that `FieldOf` knows, at most 16 of them and 512 bytes together (checked by the compiler).
/// The struct's name is the message's label.
#define MRROC_MESSAGE(Type, ...)                                                    \
  [[maybe_unused]] constexpr const char* mrroc_label(const Type*) { return #Type; } \
  template <class Visitor>                                                          \
  constexpr void mrroc_visit([[maybe_unused]] const Type* type, Visitor&& visit) {  \
    MRROC_DETAIL_EXPAND(__VA_OPT__(MRROC_DETAIL_FIELD(Type, __VA_ARGS__)))          \
    static_cast<void>(visit);                                                       \
  }                                                                                 \
  static_assert(mrroc::MessageType<Type>, #Type " is not a message: a field's type or the size is wrong");

// "for each" in the preprocessor
#define MRROC_DETAIL_PARENTHESES ()
#define MRROC_DETAIL_EXPAND(...) MRROC_DETAIL_EXPAND_4(MRROC_DETAIL_EXPAND_4(__VA_ARGS__))
#define MRROC_DETAIL_EXPAND_4(...) MRROC_DETAIL_EXPAND_2(MRROC_DETAIL_EXPAND_2(__VA_ARGS__))
#define MRROC_DETAIL_EXPAND_2(...) MRROC_DETAIL_EXPAND_1(MRROC_DETAIL_EXPAND_1(__VA_ARGS__))
#define MRROC_DETAIL_EXPAND_1(...) MRROC_DETAIL_EXPAND_0(MRROC_DETAIL_EXPAND_0(__VA_ARGS__))
#define MRROC_DETAIL_EXPAND_0(...) __VA_ARGS__
#define MRROC_DETAIL_FIELD(Type, field, ...) \
  visit(#field, &Type::field);               \
  __VA_OPT__(MRROC_DETAIL_FIELD_AGAIN MRROC_DETAIL_PARENTHESES(Type, __VA_ARGS__))
#define MRROC_DETAIL_FIELD_AGAIN() MRROC_DETAIL_FIELD

namespace mrroc {

/// A field of a message type, under its name in listings and files.
struct MessageFieldEntry {
  std::string name;
  FieldKind kind = FieldKind::number;
  std::size_t size = 0;  ///< bytes
  friend bool operator==(const MessageFieldEntry&, const MessageFieldEntry&) = default;
};

/// A message type without its C++ type: enough to make a parcel of values read from a file.
struct MessageSchema {
  std::string label;
  std::vector<MessageFieldEntry> fields;
  /// The fingerprint that a parcel of this type carries.
  std::uint64_t fingerprint() const noexcept;
  friend bool operator==(const MessageSchema&, const MessageSchema&) = default;
};

namespace detail {

constexpr void hash_field(Fnv1a& hash, std::string_view name, FieldKind kind, std::size_t size) {
  hash.add(name).add(static_cast<unsigned char>(static_cast<unsigned char>(kind) + 1));
  hash.add(std::uint64_t{size});
}

template <class T>
constexpr std::size_t size_of() {
  std::size_t size = 0;
  mrroc_visit(static_cast<const T*>(nullptr),
              [&size]<class Field>(const char*, Field T::*) { size += FieldOf<Field>::kSize; });
  return size;
}

template <class T>
constexpr std::uint64_t fingerprint_of() {
  Fnv1a hash;
  hash_field(hash, mrroc_label(static_cast<const T*>(nullptr)), FieldKind::number, 0);
  mrroc_visit(static_cast<const T*>(nullptr), [&hash]<class Field>(const char* name, Field T::*) {
    hash_field(hash, name, FieldOf<Field>::kKind, FieldOf<Field>::kSize);
  });
  return hash.value();
}

/// Throws NonFatalError(invalid_argument): the parcel's type is not the expected one.
[[noreturn]] void throw_wrong_parcel(const Message& parcel, const MessageSchema& wanted);

}  // namespace detail

/// A type declared with MRROC_MESSAGE that fits a parcel.
template <class T>
concept MessageType = requires(const T* type) {
  { mrroc_label(type) } -> std::convertible_to<const char*>;
  requires detail::size_of<T>()
  <= Message::kCapacity;
  requires std::string_view(mrroc_label(static_cast<const T*>(nullptr)))
  .size() <= kNameLength;
};

/// The label of message type T.
template <MessageType T>
constexpr std::string_view label_of() noexcept {
  return mrroc_label(static_cast<const T*>(nullptr));
}

/// Name, fields and sizes of message type T. Allocates.
template <MessageType T>
MessageSchema schema_of() {
  MessageSchema schema{std::string{label_of<T>()}, {}};
  mrroc_visit(static_cast<const T*>(nullptr), [&schema]<class Field>(const char* name, Field T::*) {
    schema.fields.push_back({name, FieldOf<Field>::kKind, FieldOf<Field>::kSize});
  });
  return schema;
}

/// The message as a parcel. Does not allocate.
template <MessageType T>
Message pack(const T& message) noexcept {
  Message parcel;
  parcel.label.assign(label_of<T>());
  parcel.fingerprint = detail::fingerprint_of<T>();
  mrroc_visit(static_cast<const T*>(nullptr), [&]<class Field>(const char*, Field T::*field) {
    FieldOf<Field>::put(message.*field, parcel.content.data() + parcel.size);
    parcel.size = static_cast<std::uint16_t>(parcel.size + FieldOf<Field>::kSize);
  });
  return parcel;
}

/// The message that a parcel carries. Throws NonFatalError(invalid_argument) when the parcel is of another type, or was
/// packed with another version of the header. Otherwise it does not allocate.
template <MessageType T>
T unpack(const Message& parcel) {
  if (parcel.fingerprint != detail::fingerprint_of<T>() || parcel.size != detail::size_of<T>())
    detail::throw_wrong_parcel(parcel, schema_of<T>());
  T message;
  std::size_t at = 0;
  mrroc_visit(static_cast<const T*>(nullptr), [&]<class Field>(const char*, Field T::*field) {
    FieldOf<Field>::get(parcel.content.data() + at, message.*field);
    at += FieldOf<Field>::kSize;
  });
  return message;
}

}  // namespace mrroc
