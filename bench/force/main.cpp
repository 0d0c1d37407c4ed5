// Distance of a force motion beside a singularity: 10 N wanted along each of the tool's three axes, b = 0.005 m/(N s),
// for 0.5 s in free space, at distances from every singularity that one joint alone leads to from home. Exit code 1
// when a contact axis moves less than half as far as 1 rad beside the singularity and the state does not report the
// rest as lost, or a joint is faster than its limit.
#include <cstdio>
#include <cstring>

#include "edp/every_robot.hpp"
#include "edp/force/singular_postures.hpp"

using namespace mrroc;
using namespace mrroc::edp;

namespace {

constexpr double kBar = 0.5;
constexpr double kForce = 10;  // N

/// Prints a row; returns whether it is within the bar.
bool row(const RobotModel& model, const SingularPosture& singular, double distance, const double (&regular)[3]) {
  std::printf("  %7.3f", distance);
  bool good = true;
  for (int axis = 0; axis < 3; ++axis) {
    double least = 0, lost = 1;
    const char* mark = "";
    for (const double sign : {-1.0, 1.0}) {
      const Pressing pressing = press(model, singular.at(distance), axis, sign * kForce);
      const double ratio = std::abs(pressing.way) / regular[axis];
      std::printf("%s%6.2f", sign < 0 ? "   " : "/", ratio);
      good = good && (ratio >= kBar || pressing.lost >= kBar) && pressing.speed <= 1 + 1e-9;
      least = std::max(least, pressing.speed);
      lost = std::min(lost, pressing.lost);
      if (pressing.ended != ErrorCode::none) mark = "*";
    }
    std::printf(" %4.2f%-1s %4.2f", lost, mark, least);
  }
  std::printf("%s\n", good ? "" : "  FAULT");
  return good;
}

}  // namespace

int main() {
  bool good = true;
  std::printf(
      "per tool axis x, y, z: path pressing / retreating, as parts of that at 1 rad; lost (* ended by `singular`); "
      "worst joint speed, a part of its limit\n");
  for (const KnownRobot& robot : every_robot()) {
    const RobotModels models = robot.load(robot.file("toml"));
    const RobotModel& model = *models.front();
    for (const SingularPosture& singular : singular_postures(model, model.parameters().home)) {
      const std::string& joint = model.parameters().axes[static_cast<std::size_t>(singular.joint)].name;
      std::printf("%s, %s %.4f\n", robot.type.c_str(), joint.c_str(), singular.joints[singular.joint]);
      double regular[3];
      for (int axis = 0; axis < 3; ++axis) regular[axis] = std::abs(press(model, singular.at(1), axis, -kForce).way);
      std::printf("        1   %.1f mm, %.1f mm, %.1f mm\n", 1000 * regular[0], 1000 * regular[1], 1000 * regular[2]);
      for (const double distance : {0.3, 0.1, 0.03, 0.01, 0.003, 0.0})
        good = row(model, singular, distance, regular) && good;
    }
  }
  return good ? 0 : 1;
}
