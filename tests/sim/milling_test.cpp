#include "sim/milling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "allocations.hpp"
#include "config/table.hpp"
#include "sim/scene/model.hpp"
#include "sim/worlds.hpp"

namespace mrroc::sim::milling_test {
namespace {

constexpr double kTimestep = 0.001, kRadius = 0.0015, kTop = 0.01;  // s, m
constexpr double kCutting = 4e7, kEdge = 2000, kThrust = 1.2, kTeeth = 600;

const std::string kDeclared = R"(<custom>
  <tuple name="milling">
    <element objtype="geom" objname="cutter"/>
    <element objtype="geom" objname="wood"/>
    <element objtype="geom" objname="board"/>
  </tuple>
  <numeric name="milling" data="4e7 2000 1.2 600"/>
</custom>)";

/// A board of 100 x 40 mm whose frame is turned and tilted, and a cutter that is put where the test wants it.
std::string scene(const std::string& custom = kDeclared) {
  return R"(<mujoco>
  <compiler angle="radian"/>
  <asset>
    <hfield name="board" nrow="3" ncol="3" size="0.05 0.02 0.02 0.01"/>
    <hfield name="wood" nrow="161" ncol="401" size="0.05 0.02 0.02 0.01"/>
  </asset>
  <worldbody>
    <geom name="board" type="hfield" hfield="board" pos="0.3 -0.1 0.2" euler="0.2 -0.1 0.7"/>
    <geom name="wood" type="hfield" hfield="wood" pos="0.3 -0.1 0.2" euler="0.2 -0.1 0.7"/>
    <body name="head" mocap="true">
      <geom name="cutter" type="sphere" size="0.0015"/>
      <geom name="weight" pos="0 0.1 -0.05" size="0.01"/>
    </body>
  </worldbody>
)" + custom +
         "</mujoco>";
}

class MillingTest : public testing::Test {
 protected:
  MillingTest() : model_(load_model(compose_texts(scratch_, scene()))), data_(make_data(*model_)) {
    const int board = mj_name2id(model_.get(), mjOBJ_HFIELD, "board");
    std::fill_n(model_->hfield_data + model_->hfield_adr[board], 9, static_cast<float>(kTop / 0.02));
    milling_ = Milling::find(*model_, "scene.xml");
    mj_kinematics(model_.get(), data_.get());
    const int geom = mj_name2id(model_.get(), mjOBJ_GEOM, "wood");
    turn_ = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data_->geom_xmat + 9 * geom);
    origin_ = Eigen::Map<const Eigen::Vector3d>(data_->geom_xpos + 3 * geom);
    // the cutter's axis is the board's normal
    const Eigen::Quaterniond down(turn_ * Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
    const double quat[4] = {down.w(), down.x(), down.y(), down.z()};
    std::copy_n(quat, 4, data_->mocap_quat);
  }

  /// The end of the cutter at x, y of the board, `depth` below its surface, m.
  void put(double x, double y, double depth) {
    const Eigen::Vector3d place = origin_ + turn_ * Eigen::Vector3d(x, y, kTop - depth + kRadius);
    std::copy_n(place.data(), 3, data_->mocap_pos);
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
    milling_->step(*model_, *data_, kTimestep);
  }

  /// A groove of 60 mm along x, at `feed`, m/s. Returns the mean force of its second half, in the board's frame.
  Eigen::Vector3d groove(double y, double depth, double feed) {
    put(-0.03, y, -0.01);
    for (int i = 0; i < 100; ++i) put(-0.03, y, depth);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const int steps = static_cast<int>(0.06 / (feed * kTimestep));
    for (int i = 1; i <= steps; ++i) {
      put(-0.03 + 0.06 * i / steps, y, depth);
      if (2 * i > steps) sum += turn_.transpose() * milling_->force();
    }
    return sum / (steps - steps / 2);
  }

  double gone() const {
    const int wood = mj_name2id(model_.get(), mjOBJ_HFIELD, "wood");
    double sum = 0;
    for (int i = 0; i < 161 * 401; ++i) sum += kTop - 0.02 * model_->hfield_data[model_->hfield_adr[wood] + i];
    return sum * (0.1 / 400) * (0.04 / 160);
  }

  /// Of a groove, m^2: a segment of the nose's circle.
  static double section(double depth) {
    const double half = std::sqrt(2 * kRadius * depth - depth * depth);
    return kRadius * kRadius * std::acos((kRadius - depth) / kRadius) - (kRadius - depth) * half;
  }

  task_test::ScratchFolder scratch_;
  Model model_;
  Data data_;
  std::optional<Milling> milling_;
  Eigen::Matrix3d turn_;
  Eigen::Vector3d origin_;
};

TEST_F(MillingTest, GrooveHasTheVolumeThatTheNosePassesThrough) {
  groove(0, 0.001, 0.02);
  const double plunge = std::numbers::pi * 1e-6 * (kRadius - 0.001 / 3);  // a cap, half of it at each end of the groove
  EXPECT_NEAR(gone() / (0.06 * section(0.001) + plunge), 1, 0.02);
}

TEST_F(MillingTest, ForceOfAGrooveIsThatOfItsSectionAndFeed) {
  double y = -0.015;
  for (const double depth : {0.0005, 0.001})
    for (const double feed : {0.01, 0.02, 0.08}) {
      const Eigen::Vector3d force = groove(y, depth, feed);
      const double drag = (kEdge + kCutting * feed / kTeeth) * section(depth) / (2 * kRadius);
      EXPECT_NEAR(-force.x() / drag, 1, 0.05) << depth << " m at " << feed << " m/s";
      EXPECT_NEAR(force.z() / (kThrust * drag), 1, 0.05);
      EXPECT_LT(std::abs(force.y()), 0.02 * drag);
      y += 0.005;
    }
}

TEST_F(MillingTest, WoodThatIsGoneDoesNotResist) {
  groove(0, 0.001, 0.02);
  const double before = gone();
  EXPECT_LT(groove(0, 0.001, 0.02).norm(), 1e-9);
  EXPECT_EQ(gone(), before);
  EXPECT_FALSE(milling_->removed_at());
}

TEST_F(MillingTest, ForceActsAtTheEndOfTheNose) {
  groove(0, 0.001, 0.02);
  const int body = mj_name2id(model_.get(), mjOBJ_BODY, "head");
  const Eigen::Vector3d end = origin_ + turn_ * Eigen::Vector3d(0.03, 0, kTop - 0.001);
  const Eigen::Vector3d arm = end - Eigen::Map<const Eigen::Vector3d>(data_->xipos + 3 * body);
  const Eigen::Vector3d force = Eigen::Map<const Eigen::Vector3d>(data_->xfrc_applied + 6 * body);
  const Eigen::Vector3d torque = Eigen::Map<const Eigen::Vector3d>(data_->xfrc_applied + 6 * body + 3);
  EXPECT_GT(force.norm(), 1);
  EXPECT_LT((torque - arm.cross(force)).norm(), 1e-9);
}

TEST_F(MillingTest, StepAllocatesNothing) {
  groove(0, 0.0005, 0.02);
  {
    const test::Counting counting;
    for (int i = 0; i < 1000; ++i) put(-0.03 + 2e-5 * i, 0, 0.001);
  }
  EXPECT_EQ(test::Counting::counted(), 0U);
}

TEST(MillingDeclaration, IsLeftOut) {
  const task_test::ScratchFolder scratch;
  const Model model = load_model(compose_texts(scratch, scene("")));
  EXPECT_FALSE(Milling::find(*model, "scene.xml"));
}

TEST(MillingDeclaration, IsRefusedByWhatIsWrongWithIt) {
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = kDeclared;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  const std::pair<std::string, std::string> kWrong[] = {
      {changed("tuple name=\"milling\"", "tuple name=\"mill\""), "custom"},
      {changed("numeric name=\"milling\"", "numeric name=\"mill\""), "custom"},
      {changed("1.2 600", "1.2"), "custom.numeric.milling"},
      {changed("1.2 600", "1.2 0"), "custom.numeric.milling"},
      {changed("4e7", "-1"), "custom.numeric.milling"},
      {changed("objname=\"cutter\"", "objname=\"board\""), "custom.tuple.milling"},
      {changed("objname=\"wood\"", "objname=\"weight\""), "custom.tuple.milling"},
      {changed("<element objtype=\"geom\" objname=\"board\"/>", ""), "custom.tuple.milling"},
      {changed("objtype=\"geom\" objname=\"cutter\"", "objtype=\"body\" objname=\"head\""), "custom.tuple.milling"}};
  for (const auto& [custom, key] : kWrong) {
    const task_test::ScratchFolder scratch;
    try {
      load_model(compose_texts(scratch, scene(custom)));
      ADD_FAILURE() << "accepted: " << custom;
    } catch (const config::ConfigurationError& error) {
      EXPECT_NE(std::string(error.what()).find(": " + key + ": "), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace mrroc::sim::milling_test
