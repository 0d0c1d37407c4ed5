#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "canopen/eds_sections.hpp"
#include "canopen/object_value.hpp"
#include "canopen/objects.hpp"

namespace mrroc::canopen {

/// One value of a node's object dictionary, as described by its manufacturer.
struct ObjectEntry {
  std::string name;
  DataType type = DataType::unsigned32;
  std::string access;           ///< ro | wo | rw | rwr | rww | const
  std::string default_value;    ///< from the file, without comment and quotes; may be empty
  std::string parameter_value;  ///< the same, of a DCF
  bool mappable = false;        ///< into a PDO

  bool readable() const noexcept { return access != "wo"; }
  bool writable() const noexcept { return access != "ro" && access != "const"; }
};

/// A node's object dictionary from its electronic data sheet (CiA 306-1): values by address, and by name.
///
/// A section of a record or array gives only the name: its own AccessType and DataType are ignored. In a DCF,
/// ParameterValue is read too.
///
/// Names are those of the file, not case-sensitive. A sub-value is named "<object>/<value>", like "Identity
/// object/Vendor-ID"; those that the file describes at once (CompactSubObj) without names are "<object>/<object>1",
/// "<object>/<object>2". A name that two objects share denotes the first. Configuration time.
class EdsFile {
 public:
  /// Throws EdsError: unreadable, refused by `read_eds_sections` or `expected_value`, a missing type or access or one
  /// that the standard does not define, an object or a part without a name or in two sections, a misspelt address of a
  /// section with DataType or AccessType, a key twice with two values, more than 254 parts.
  static EdsFile load(const std::filesystem::path& file);
  /// `name`: for messages.
  static EdsFile parse(std::string_view text, const std::string& name);

  /// Adds the objects of axis `channel` as copies of those of the first axis: of the profile, and of two PDOs in each
  /// direction from number `first_pdo` on, which are not used by default.
  void repeat_axis(int channel, int first_pdo);

  /// The dictionary as a drive with this axis alone has it.
  EdsFile of_axis(int channel, int first_pdo) const;

  const std::map<Object, ObjectEntry>& entries() const noexcept { return entries_; }
  /// Null when it has no such object.
  const ObjectEntry* find(Object object) const noexcept;
  /// The address from a person's text: a name, or "0x6040", "0x1018:1". Throws std::invalid_argument that lists similar
  /// names.
  Object object(std::string_view text) const;
  /// The name of the device; empty when it is not in the file.
  const std::string& product() const noexcept { return product_; }

 private:
  void read_objects(const std::vector<EdsSection>& sections, const std::string& name);
  void add(Object object, const std::string& parent, ObjectEntry entry);
  void add_parts(const ObjectEntry& all, std::uint16_t index, std::uint32_t count,
                 const std::map<std::uint32_t, const EdsLine*>& names,
                 const std::map<std::uint32_t, const EdsLine*>& values);

  std::map<Object, ObjectEntry> entries_;
  std::map<std::string, Object> names_;  ///< in small letters
  std::string product_;
};

}  // namespace mrroc::canopen
