#pragma once

#include <string>
#include <string_view>

namespace mrroc::links {

/// `prefix`/`name`, checked: letters, digits, `_` and `/` only, beginning with a letter or `_`, no empty part, at most
/// 95 characters. Throws SystemError (configuration) that quotes the name and the problem.
std::string topic_name(std::string_view prefix, std::string_view name);

/// The same check for a whole name.
void check_topic_name(std::string_view topic);

}  // namespace mrroc::links
