#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "system/equal_runs.hpp"
#include "system/trace_steps_of.hpp"
#include "text_of.hpp"

namespace mrroc::test::inspect_test {
namespace {

using Eigen::Vector3d;

const std::filesystem::path kTask = std::filesystem::path(MRROC_SOURCE_DIR) / "tasks/inspect";

/// Pose of a tool relative to the scene's plate.
struct Place {
  double beside, before, lean;  // m from the spot along the plate, m from its surface, rad off its normal
};

Place place_of(const std::vector<double>& pose) {
  const Eigen::Affine3d plate = Eigen::Translation3d(0.82, 0.06, 0.36 - 0.7) *
                                Eigen::AngleAxisd(0.16, Vector3d::UnitX()) *
                                Eigen::AngleAxisd(-0.12, Vector3d::UnitY()) * Eigen::Translation3d(0, 0, 0.01);
  const Vector3d tool = plate.inverse() * Vector3d(pose.at(0), pose.at(1), pose.at(2));
  const Vector3d axis = Eigen::Quaterniond(pose.at(3), pose.at(4), pose.at(5), pose.at(6)) * Vector3d::UnitZ();
  return {tool.head<2>().norm(), tool.z(), std::acos(std::min(1.0, -axis.dot(plate.linear() * Vector3d::UnitZ())))};
}

/// The tool's pose in the last step of the Move with a generator.
Place last_place(const std::filesystem::path& trace, const std::string& generator) {
  const Steps steps = steps_of(trace, generator);
  if (steps.empty()) throw std::runtime_error("no step of " + generator);
  return place_of(steps.back().robots.at(0).pose);
}

TEST(Inspect, BringsTheGaugeSquareBeforeAPlateThatItsCameraHasFound) {
  const ScratchFolder folder;
  const EqualRuns runs = expect_equal_runs("tasks/inspect/inspect.toml", folder, MrrocRun::kLongPatience);
  ASSERT_FALSE(testing::Test::HasFailure());
  struct Expected {
    const char* generator;
    double before;
  };
  for (const auto& [generator, before] :
       {Expected{"PositionServo", 0.3}, {"ImageServo", 0.2}, {"GuardedApproach", 0.15}}) {
    const Place place = last_place(runs.trace, generator);
    std::printf("%s: %.2f mm beside the spot, %.2f mm before the plate, %.2f degrees off its normal\n", generator,
                1000 * place.beside, 1000 * place.before, 57.3 * place.lean);
    EXPECT_LT(place.beside, 0.003) << generator;
    EXPECT_NEAR(place.before, before, 0.003) << generator;
    EXPECT_LT(place.lean, 0.015) << generator;
  }
}

TEST(Inspect, TaskReportsAMissingPlate) {
  const ScratchFolder folder;
  std::string scene = text_of(kTask / "inspect.xml");
  const std::string material = "material=\"marker\"";
  ASSERT_NE(scene.find(material), std::string::npos);
  scene.erase(scene.find(material), material.size());  // a plate without a marker
  folder.write("inspect.xml", scene);
  folder.write("marker_4x4_50_11.png", text_of(kTask / "marker_4x4_50_11.png"));
  const std::string output =
      run_mrroc({"run", folder.write("inspect.toml", text_of(kTask / "inspect.toml")).string()}, 1);
  EXPECT_NE(output.find("there is no plate"), std::string::npos) << output;
}

}  // namespace
}  // namespace mrroc::test::inspect_test
