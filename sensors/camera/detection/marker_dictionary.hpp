#pragma once

#include <opencv2/aruco.hpp>
#include <string>
#include <vector>

namespace mrroc::vsp {

/// OpenCV's predefined ArUco dictionary of this name ("4X4_50"); null when it does not exist.
cv::Ptr<cv::aruco::Dictionary> marker_dictionary(const std::string& name);
std::vector<std::string> marker_dictionary_names();

}  // namespace mrroc::vsp
