// camera_marker: an ArUco marker as a PNG file, to print or to use in a scene.
#include <signal.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "command/number_option.hpp"
#include "command/parse_command.hpp"
#include "command/printable.hpp"
#include "command/write_file.hpp"
#include "process/standard_files.hpp"
#include "sensors/camera/detection/marker_dictionary.hpp"
#include "sensors/camera/keys.hpp"

namespace {

int draw(int argc, char** argv) {
  std::string dictionary_name = "4X4_50", out;
  int marker = 0, cell = 16;
  CLI::App app{"Draws an ArUco marker as a PNG file, with a white margin of one cell."};
  app.add_option("--dictionary", dictionary_name, "4X4_50, ..., APRILTAG_36h11");
  mrroc::command::add_number(app, "--marker", marker, 0, 100'000, "its number in the dictionary");
  mrroc::command::add_number(app, "--cell", cell, 1, 256, "pixels per cell");
  app.add_option("--out", out, "PNG file to write")->required();
  if (const auto exit_code = mrroc::command::parse_command(app, argc, argv)) return *exit_code;
  const auto dictionary = mrroc::vsp::marker_dictionary(dictionary_name);
  if (!dictionary) {
    throw std::runtime_error("no dictionary " + dictionary_name + ", expected one of " +
                             mrroc::vsp::listed(mrroc::vsp::marker_dictionary_names()));
  }
  if (marker >= dictionary->bytesList.rows) {
    throw std::runtime_error("marker " + std::to_string(marker) + ", expected 0 to " +
                             std::to_string(dictionary->bytesList.rows - 1));
  }
  const int cells = dictionary->markerSize + 2;  // with its black border
  cv::Mat square, picture;
  dictionary->drawMarker(marker, cells * cell, square, 1);
  cv::copyMakeBorder(square, picture, cell, cell, cell, cell, cv::BORDER_CONSTANT, cv::Scalar(255));
  std::vector<unsigned char> png;
  if (!cv::imencode(".png", picture, png)) throw std::runtime_error("cannot encode the picture");
  mrroc::command::write_file(out, std::as_bytes(std::span(png)));
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  mrroc::process::open_standard_files();
  signal(SIGXFSZ, SIG_IGN);  // a file size limit is an error of the write
  return draw(argc, argv);
} catch (const std::exception& error) {
  std::fprintf(stderr, "camera_marker: %s\n", mrroc::command::printable_lines(error.what()).c_str());
  return 2;
}
