#include "kinematics/closed_form.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "kinematics/chains.hpp"
#include "kinematics/newton.hpp"

namespace mrroc::kinematics {
namespace {

using namespace test;

constexpr double kExact = 1e-9;

struct Arm {
  const char* name;
  SerialChain (*make)(std::mt19937_64& random);
  Structure structure;
};

void PrintTo(const Arm& arm, std::ostream* out) { *out << arm.name; }

const Arm kArms[]{{"ur5e", [](std::mt19937_64&) { return ur5e(); }, Structure::three_parallel},
                  {"puma560", [](std::mt19937_64&) { return puma560(); }, Structure::wrist_after_parallel},
                  {"irb140", [](std::mt19937_64&) { return irb140(); }, Structure::wrist_after_parallel},
                  {"parallel_elbow", [](std::mt19937_64& r) { return random_wrist_arm(r, false, true, false, false); },
                   Structure::wrist_after_parallel},
                  {"parallel_base", [](std::mt19937_64& r) { return random_wrist_arm(r, true, false, false, false); },
                   Structure::wrist_after_parallel_base},
                  {"crossing_base", [](std::mt19937_64& r) { return random_wrist_arm(r, false, false, true, false); },
                   Structure::wrist_after_crossing_base},
                  {"crossing_elbow", [](std::mt19937_64& r) { return random_wrist_arm(r, false, false, false, true); },
                   Structure::wrist_after_crossing_elbow},
                  {"skew", [](std::mt19937_64& r) { return random_chain(r, 6, false); }, Structure::none}};

double difference(const JointVector& a, const JointVector& b) {
  double largest = 0;
  for (int i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(std::remainder(a[i] - b[i], 2 * std::numbers::pi)));
  return largest;
}

class ClosedFormTest : public testing::TestWithParam<Arm> {
 protected:
  ClosedFormTest() { std::printf("seed 1\n"); }
  std::mt19937_64 random{1};
};

/// For random postures: the posture itself is found, and every posture found gives the pose.
TEST_P(ClosedFormTest, FindsEveryBranch) {
  std::size_t branches = 0;
  for (int round = 0; round < 3000; ++round) {
    const SerialChain chain = GetParam().make(random);
    const ClosedForm inverse(chain);
    ASSERT_EQ(inverse.structure(), GetParam().structure);
    if (!inverse) continue;
    const JointVector q = random_joints(random, 6);
    const Pose pose = chain.flange(q);
    ClosedForm::Postures postures;
    inverse.solve(pose, random_joints(random, 6), kExact, postures);
    bool found = false;
    for (std::size_t i = 0; i < postures.count; ++i) {
      const Twist error = displacement(chain.flange(postures.joints[i]), pose);
      ASSERT_LT(error.norm(), 2 * kExact);
      for (std::size_t j = 0; j < i; ++j) ASSERT_GT(difference(postures.joints[i], postures.joints[j]), 1e-7);
      found = found || difference(postures.joints[i], q) < 1e-5;
    }
    ASSERT_TRUE(found) << GetParam().name << ", round " << round << ": " << q.transpose();
    branches += postures.count;
  }
  std::printf("%s: %.2f postures for a pose\n", GetParam().name, static_cast<double>(branches) / 3000);
}

TEST_P(ClosedFormTest, FindsNothingBeyondTheReach) {
  const SerialChain chain = GetParam().make(random);
  const ClosedForm inverse(chain);
  for (int round = 0; round < 100; ++round) {
    Pose pose = random_pose(random);
    pose.translation() = 30 * random_vector(random).normalized();
    ClosedForm::Postures postures;
    inverse.solve(pose, random_joints(random, 6), kExact, postures);
    ASSERT_EQ(postures.count, 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Arms, ClosedFormTest, testing::ValuesIn(kArms),
                         [](const auto& test) { return std::string{test.param.name}; });

/// With aligned axes the free joint keeps its value.
TEST(ClosedForm, FreeJointKeepsItsValue) {
  std::mt19937_64 random(2);
  std::printf("seed 2\n");
  const SerialChain wrist = puma560(), parallel = ur5e();
  for (int round = 0; round < 300; ++round) {
    JointVector q = random_joints(random, 6);
    q[4] = 0;
    ClosedForm::Postures postures;
    ClosedForm(wrist).solve(wrist.flange(q), q, kExact, postures);
    EXPECT_TRUE(postures.singular);
    bool kept = false;
    for (std::size_t i = 0; i < postures.count; ++i) kept = kept || difference(postures.joints[i], q) < 1e-4;
    EXPECT_TRUE(kept) << "wrist, round " << round;
    ClosedForm(parallel).solve(parallel.flange(q), q, kExact, postures);
    kept = false;
    for (std::size_t i = 0; i < postures.count; ++i) kept = kept || difference(postures.joints[i], q) < 1e-4;
    EXPECT_TRUE(kept) << "three parallel, round " << round;
  }
}

/// A URDF with five digits of an angle has axes that are parallel within some microradians.
TEST(ClosedForm, NearlyParallelAxesCount) {
  std::mt19937_64 random(3);
  std::printf("seed 3\n");
  std::uniform_real_distribution<double> off(-4e-6, 4e-6);
  for (int round = 0; round < 200; ++round) {
    const SerialChain chain = chain_of({{0.1625, 0, kRight + off(random)},
                                        {0, -0.425, off(random)},
                                        {0, -0.3922, off(random)},
                                        {0.1333, 0, kRight + off(random)},
                                        {0.0997, 0, -kRight},
                                        {0.0996, 0, 0}});
    const ClosedForm inverse(chain);
    ASSERT_EQ(inverse.structure(), Structure::three_parallel);
    const JointVector q = random_joints(random, 6);
    ClosedForm::Postures postures;
    inverse.solve(chain.flange(q), q, kExact, postures);
    bool found = false;
    for (std::size_t i = 0; i < postures.count; ++i) found = found || difference(postures.joints[i], q) < 1e-4;
    EXPECT_TRUE(found) << round;
  }
}

TEST(Newton, ConvergesFromNearby) {
  std::mt19937_64 random(4);
  std::printf("seed 4\n");
  for (const SerialChain& chain : {ur5e(), panda()}) {
    int reached = 0;
    for (int round = 0; round < 1000; ++round) {
      const JointVector q = random_joints(random, chain.size());
      JointVector start = q + 0.1 * random_joints(random, chain.size());
      reached += improve(chain, chain.flange(q), kExact, 60, start) ? 1 : 0;
    }
    std::printf("%d of 1000\n", reached);
    EXPECT_GT(reached, 980);
  }
}

TEST(Newton, StaysInItsRange) {
  std::mt19937_64 random(5);
  std::printf("seed 5\n");
  const SerialChain chain = panda();
  const JointRange range{JointVector::Constant(7, -1), JointVector::Constant(7, 1)};
  for (int round = 0; round < 500; ++round) {
    JointVector q = 0.3 * random_joints(random, 7), start = JointVector::Zero(7);
    improve(chain, chain.flange(q), kExact, 60, start, &range);
    EXPECT_LE(start.cwiseAbs().maxCoeff(), 1.0);
  }
}

}  // namespace
}  // namespace mrroc::kinematics
