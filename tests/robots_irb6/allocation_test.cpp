#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "irb6_fixture.hpp"

namespace {
std::atomic<long> allocations{0};
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace mrroc {
namespace {

TEST(Irb6Allocation, TheCounterCounts) {
  const long before = allocations;
  ::operator delete(::operator new(8));
  EXPECT_EQ(allocations - before, 1);
}

TEST(Irb6Allocation, NoMethodAllocates) {
  const RobotModel& model = irb6_model();
  std::mt19937_64 random(20060103);
  std::vector<JointVector> postures;
  for (int i = 0; i < 100; ++i) postures.push_back(random_posture(random));
  JointVector motors, joints;
  double sum = 0;
  const long before = allocations;
  for (const JointVector& posture : postures) {
    const Pose pose = model.direct(posture);
    model.inverse(pose, model.parameters().home, joints);
    model.joints_to_motors(posture, motors);
    model.motors_to_joints(motors, joints);
    sum += model.transmission(posture).sum() + model.jacobian(posture).sum() + joints.sum();
  }
  EXPECT_EQ(allocations - before, 0);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace
}  // namespace mrroc
