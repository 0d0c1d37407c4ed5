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

/// One value of a node's object dictionary, as its maker describes it.
struct ObjectEntry {
  std::string name;
  DataType type = DataType::unsigned32;
  std::string access;           ///< ro | wo | rw | rwr | rww | const
  std::string default_value;    ///< as the file has it, without comment and quotes; empty: none
  std::string parameter_value;  ///< the same, of a DCF
  bool mappable = false;        ///< into a PDO

  bool readable() const noexcept { return access != "wo"; }
  bool writable() const noexcept { return access != "ro" && access != "const"; }
};

/// A node's object dictionary from its electronic data sheet (CiA 306-1): values by address, and by name.
///
/// A section of a record or array gives the name alone: its own AccessType and DataType, blank or not, mean nothing. Of
/// a DCF, ParameterValue is read too.
///
/// Names are those of the file, whatever the case of their letters; a sub-value is called "<object>/<value>", like
/// "Identity object/Vendor-ID"; those that the file describes at once (CompactSubObj) and does not name are called
/// "<object>/<object>1", "<object>/<object>2". Where two objects have one name, the name stands for the first.
/// Configuration time.
class EdsFile {
 public:
  /// Throws EdsError: unreadable, what `read_eds_sections` and `expected_value` refuse, a type or access that the
  /// standard does not know or that is missing, an object or a part without a name or in two sections, a key twice with
  /// two values, more than 254 parts.
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
