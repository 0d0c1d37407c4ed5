#include "sim/rendering/camera.hpp"

#include <gtest/gtest.h>
#include <png.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

#include "sim/simulation.hpp"
#include "sim/worlds.hpp"

namespace mrroc::sim::camera_test {
namespace {

using config::message_of;
using task_test::ScratchFolder;
using Colour = std::array<std::uint8_t, 3>;

Picture read_png(const std::filesystem::path& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_file(&image, file.c_str()), 0) << image.message;
  image.format = PNG_FORMAT_RGB;
  Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.pixels.resize(PNG_IMAGE_SIZE(image));
  png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr);
  return picture;
}

Colour pixel(const Picture& picture, int x, int y) {
  const auto at =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
  return {picture.pixels[at], picture.pixels[at + 1], picture.pixels[at + 2]};
}

std::size_t colours(const Picture& picture) {
  std::set<Colour> found;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) found.insert(pixel(picture, x, y));
  }
  return found.size();
}

bool is_reddish(const Colour& c) { return c[0] > 90 && c[0] > 2 * c[1] && c[0] > 2 * c[2]; }

/// Number and mean row of the red box's pixels.
struct Red {
  int count = 0;
  double row = 0, column = 0;
};
Red red_of(const Picture& picture) {
  Red red;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (!is_reddish(pixel(picture, x, y))) continue;
      ++red.count;
      red.row += y;
      red.column += x;
    }
  }
  red.row /= std::max(red.count, 1);
  red.column /= std::max(red.count, 1);
  return red;
}

class Camera : public testing::Test {
 protected:
  Camera() { setenv("MRROC_SHARE", kData.c_str(), 1); }
};

TEST_F(Camera, ShowsTheWorldAndItsMotion) {
  const auto deployment = twolink_deployment(2);
  auto memory = std::make_unique<world::WorldMemory>();
  Simulation simulation(deployment, *memory);
  const Model model = load_model(compose(deployment));
  Renderer renderer(*model, 320, 240);
  const WorldState start = simulation.state();
  const Picture first = renderer.render(start.positions, "overview");
  EXPECT_EQ(first.width, 320);
  EXPECT_EQ(first.height, 240);
  EXPECT_GT(colours(first), 200U) << "a uniform picture";
  const Red box = red_of(first);
  EXPECT_GT(box.count, 30) << "the red box is not visible";

  std::vector<double> lifted = start.positions;
  const int joint = mj_name2id(model.get(), mjOBJ_JOINT, "box");
  lifted[static_cast<std::size_t>(model->jnt_qposadr[joint]) + 2] += 0.3;
  const Red higher = red_of(renderer.render(lifted, "overview"));
  EXPECT_GT(higher.count, 30);
  EXPECT_LT(higher.row, box.row - 10) << "rows go from top to bottom";
  EXPECT_NEAR(higher.column, box.column, 8);

  EXPECT_EQ(renderer.render(start.positions, "overview").pixels, first.pixels) << "the same state, another picture";
  EXPECT_GT(colours(renderer.render(start.positions, "")), 200U) << "the free camera";
}

TEST_F(Camera, RefusesAMissingCameraOrAnotherWorldsState) {
  const Model model = load_model(compose(kData / "scene.xml", {}));
  Renderer renderer(*model, 64, 48);
  const std::vector<double> positions(model->qpos0, model->qpos0 + model->nq);
  EXPECT_EQ(message_of({}, [&] { renderer.render(positions, "front"); }),
            "camera: no camera \"front\", expected one of overview");
  EXPECT_EQ(message_of({},
                       [&] {
                         renderer.render({1, 2, 3}, "overview");
                       }),
            "state: 3 positions, expected 14, as this world has");
}

class RenderProgram : public Camera {
 protected:
  RenderProgram() {
    // a deployment names programs that must exist; this test does not run them
    for (const char* program : {"mrroc_sim", "mrroc_mp", "mrroc_ecp", "twolink_edp"}) {
      chmod(scratch_.write(std::string("bin/") + program, "").c_str(), 0755);
    }
    setenv("MRROC_PROGRAMS", (scratch_.path() / "bin").c_str(), 1);
    deployment_ = scratch_.write("test.toml",
                                 "[deployment]\nname = \"test\"\n[robots.arm]\ntype = \"twolink\"\n"
                                 "hardware = \"mujoco\"\nposition = [0.0, 0.0, 0.5]\n"
                                 "[sim]\nscene = \"" +
                                     (kData / "scene.xml").string() + "\"\n");
  }
  int run(const std::string& arguments) const {
    const std::string command = std::string(MRROC_BINARY_DIR) + "/bin/mrroc_render --deployment " +
                                deployment_.string() + " " + arguments + " 2>" + (scratch_.path() / "err").string();
    return WEXITSTATUS(std::system(command.c_str()));
  }
  ScratchFolder scratch_;
  std::filesystem::path deployment_;
};

TEST_F(RenderProgram, WritesAPngOfASavedState) {
  auto memory = std::make_unique<world::WorldMemory>();
  Simulation simulation(config::load_deployment(deployment_), *memory);
  simulation.publish_initial();
  for (Tick k = 1; k <= 300; ++k) simulation.step(k);
  const auto state = scratch_.path() / "00000300.state", png = scratch_.path() / "out.png";
  save_state(state, simulation.state());
  ASSERT_EQ(run("--camera overview --width 200 --height 150 --state " + state.string() + " --out " + png.string()), 0);
  const Picture picture = read_png(png);
  EXPECT_EQ(picture.width, 200);
  EXPECT_EQ(picture.height, 150);
  EXPECT_GT(colours(picture), 200U);
}

TEST_F(RenderProgram, ReplacesOnlyPictures) {
  const std::string options = "--camera overview --width 64 --height 48 --out ";
  for (const char* name : {"scene.xml", "notes.png"}) {
    const auto mine = scratch_.write(name, "<mujocoinclude/>");
    EXPECT_EQ(run(options + mine.string()), 2) << name;
    EXPECT_EQ(std::filesystem::file_size(mine), 16U) << name;
  }
  for (int i = 0; i < 2; ++i) EXPECT_EQ(run(options + (scratch_.path() / "again.png").string()), 0);
}

TEST_F(RenderProgram, ReportsErrors) {
  EXPECT_EQ(run("--camera none --width 64 --height 48 --out " + (scratch_.path() / "out.png").string()), 2);
  std::ifstream err(scratch_.path() / "err");
  std::string line;
  std::getline(err, line);
  EXPECT_EQ(line, "mrroc_render: camera: no camera \"none\", expected one of overview");
}

}  // namespace
}  // namespace mrroc::sim::camera_test
