#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

#include "canopen/object_value.hpp"
#include "canopen/objects.hpp"

namespace mrroc::canopen {

/// A mistake in an EDS file: "<file>:<line>: <section>: <key>: <what is wrong>, expected <what>".
class EdsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One value of a node's object dictionary, as its maker describes it.
struct ObjectEntry {
  std::string name;
  DataType type = DataType::unsigned32;
  std::string access;         ///< ro | wo | rw | rwr | rww | const
  std::string default_value;  ///< as the file has it; empty: none
  bool mappable = false;      ///< into a PDO

  bool readable() const noexcept { return access != "wo"; }
  bool writable() const noexcept { return access != "ro" && access != "const"; }
};

/// A node's object dictionary from its electronic data sheet (CiA 306-1): values by address, and by name.
///
/// Names are those of the file, whatever the case of their letters; a sub-value is called "<object>/<value>", like
/// "Identity object/Vendor-ID"; those that the file describes at once (CompactSubObj) and does not name are called
/// "<object>/<object>1", "<object>/<object>2". Where two objects have one name, the name stands for the first.
/// Configuration time.
class EdsFile {
 public:
  /// Throws EdsError: unreadable, a line that is neither section nor key nor comment, a number that is none, a type or
  /// access that the standard does not know, a section without a name, more than 254 parts.
  static EdsFile load(const std::filesystem::path& file);
  /// `name`: for messages.
  static EdsFile parse(std::string_view text, const std::string& name);

  const std::map<Object, ObjectEntry>& entries() const noexcept { return entries_; }
  /// Null: it has no such object.
  const ObjectEntry* find(Object object) const noexcept;
  /// The address that a person writes: a name, or "0x6040", "0x1018:1". Throws std::invalid_argument that says which
  /// names come near.
  Object object(std::string_view text) const;
  /// The name of the device; empty: the file does not say.
  const std::string& product() const noexcept { return product_; }

 private:
  void add(Object object, const std::string& parent, ObjectEntry entry);
  void add_parts(const ObjectEntry& all, std::uint16_t index, std::uint32_t count,
                 const std::map<std::uint32_t, std::string>& names, const std::map<std::uint32_t, std::string>& values);

  std::map<Object, ObjectEntry> entries_;
  std::map<std::string, Object> names_;  ///< in small letters
  std::string product_;
};

}  // namespace mrroc::canopen
