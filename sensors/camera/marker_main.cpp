// camera_marker: an ArUco marker as a PNG file, to print or to put into a scene.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>

#include "sensors/camera/keys.hpp"
#include "sensors/camera/marker_dictionary.hpp"

int main(int argc, char** argv) {
  std::string dictionary_name = "4X4_50", out;
  int marker = 0, cell = 16;
  CLI::App app{"Draws an ArUco marker as a PNG file, with a white margin of one cell."};
  app.add_option("--dictionary", dictionary_name, "4X4_50, ..., APRILTAG_36h11");
  app.add_option("--marker", marker, "its number in the dictionary")->check(CLI::NonNegativeNumber);
  app.add_option("--cell", cell, "pixels per cell")->check(CLI::Range(1, 256));
  app.add_option("--out", out, "PNG file to write")->required();
  CLI11_PARSE(app, argc, argv);
  const auto dictionary = mrroc::vsp::marker_dictionary(dictionary_name);
  if (!dictionary) {
    std::fprintf(stderr, "camera_marker: no dictionary %s, expected one of %s\n", dictionary_name.c_str(),
                 mrroc::vsp::listed(mrroc::vsp::marker_dictionary_names()).c_str());
    return 2;
  }
  if (marker >= dictionary->bytesList.rows) {
    std::fprintf(stderr, "camera_marker: marker %d, expected 0 to %d\n", marker, dictionary->bytesList.rows - 1);
    return 2;
  }
  const int cells = dictionary->markerSize + 2;  // with its black border
  cv::Mat square, picture;
  dictionary->drawMarker(marker, cells * cell, square, 1);
  cv::copyMakeBorder(square, picture, cell, cell, cell, cell, cv::BORDER_CONSTANT, cv::Scalar(255));
  if (!cv::imwrite(out, picture)) {
    std::fprintf(stderr, "camera_marker: cannot write %s\n", out.c_str());
    return 2;
  }
  return 0;
}
