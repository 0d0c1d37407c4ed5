#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mrroc::test {

/// The numbers, separated by commas, that follow the first `field` of a line of a trace, up to the next blank: those of
/// "pose=0.1,0.2". None when the line does not have the field.
std::vector<double> numbers_after(const std::string& line, const std::string& field);

/// Steps of a trace that contain `text`, as its lines; none when there is no such file.
std::vector<std::string> lines_with(const std::filesystem::path& trace, const std::string& text);

}  // namespace mrroc::test
