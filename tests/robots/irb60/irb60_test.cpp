#include <gtest/gtest.h>

#include "robots/irb6/family/changed_file.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "robots/irb60/irb60_model.hpp"

namespace mrroc {
namespace {

TEST(Irb60, HasTheInterfaceOfTheIrb6) {
  const auto irb60 = load_irb60(), irb6 = load_irb6(robot_file("irb6", "toml"));
  ASSERT_EQ(irb60.front()->joint_count(), irb6.front()->joint_count());
  EXPECT_EQ(irb60.front()->parameters().type, "irb60");
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(irb60.front()->parameters().axes[i].name, irb6.front()->parameters().axes[i].name);
  }
}

TEST(Irb60, UsesOnlyTheNumbersOfItsFile) {
  const auto longer = load_with([](const std::filesystem::path& file) { return load_irb6(file); }, "upper_arm = 1.05",
                                "upper_arm = 1.15");
  JointVector level(6);
  level << 0, -M_PI / 2, 0, 0, 0, 0;
  const Eigen::Vector3d change = longer.front()->flange(level).translation() - robot().flange(level).translation();
  EXPECT_LT((change - Eigen::Vector3d(0.1, 0, 0)).norm(), 1e-12);
}

TEST(Irb60, ReachesFurtherThanTheIrb6) {
  const auto irb6 = load_irb6(robot_file("irb6", "toml"));
  EXPECT_GT(robot().flange(robot().parameters().home).translation().x(),
            irb6.front()->flange(irb6.front()->parameters().home).translation().x() + 0.4);
}

}  // namespace
}  // namespace mrroc
