#pragma once

#include <tinyxml2.h>

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mrroc/types.hpp"

namespace mrroc::edp {

/// The elements of one URDF; mistakes in them are ConfigurationErrors that name file, line and attribute. Configuration
/// time only.
class UrdfReader {
 public:
  using Element = tinyxml2::XMLElement;

  /// `file` must outlive the reader.
  explicit UrdfReader(const std::filesystem::path& file) : file_(file) {}

  /// Reads the file and returns its element `<robot>`, which lives as long as the reader. Throws: what
  /// config::read_xml refuses, another root, xacro that is not expanded.
  const Element& robot();

  /// The value of attribute `name`. Throws: missing or empty.
  std::string text(const Element& element, const char* name) const;
  /// The child element of this name, null without one. Throws for a second one.
  const Element* optional_child(const Element& element, const char* name) const;
  /// Throws for an attribute with another name; those of other namespaces are ignored.
  void only(const Element& element, const std::vector<std::string>& names) const;
  /// The first child element `name`. Throws: missing.
  const Element& child(const Element& element, const char* name) const;
  /// All numbers of an attribute, the same in every locale; `fallback` when it is missing. Throws: another count of
  /// numbers, text that core::to_finite refuses.
  template <int size>
  Eigen::Matrix<double, size, 1> numbers(const Element& element, const char* name,
                                         const Eigen::Matrix<double, size, 1>& fallback) const {
    const std::vector<double> values = all_numbers(element, name, size);
    if (values.empty()) return fallback;
    return Eigen::Map<const Eigen::Matrix<double, size, 1>>(values.data());
  }
  /// One number; nothing when the attribute is missing.
  std::optional<double> number(const Element& element, const char* name) const;
  /// One number. Throws: missing.
  double required(const Element& element, const char* name) const;
  /// The child element `<origin xyz rpy>`; the identity when it is missing.
  Pose origin(const Element& element) const;

  [[noreturn]] void fail(const Element& element, const std::string& attribute, const std::string& problem,
                         const std::string& expected) const;

 private:
  std::vector<double> all_numbers(const Element& element, const char* name, std::size_t size) const;
  void refuse_macros(const Element& robot) const;

  const std::filesystem::path& file_;
  tinyxml2::XMLDocument document_;
};

}  // namespace mrroc::edp
