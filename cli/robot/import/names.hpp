#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace mrroc::cli {

/// `text` with every character but letters, digits, `_`, `-` and `.` replaced by `_`; `part` when it is empty.
std::string plain_name(std::string_view text);

/// A robot's name as the name of a type: letters, digits and `_`, first a letter.
std::string type_name(std::string_view robot);

/// Unique names of at most `longest` characters for `names`, in the same order: plain, and shortened where they are
/// longer.
std::vector<std::string> unique_names(const std::vector<std::string>& names, std::size_t longest);

}  // namespace mrroc::cli
