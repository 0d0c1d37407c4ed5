#include "sim/contact_filter.hpp"

#include <cstdio>
#include <tuple>

#include "language/property.hpp"
#include "language/random_values.hpp"
#include "sim/scene/model.hpp"
#include "worlds.hpp"

namespace mrroc::sim::contact_filter_test {
namespace {

using fakes::check_property;
using fakes::pick;

constexpr int kCases = 60;
constexpr int kBodies = 12;

std::string text(const std::string& key, const std::vector<double>& values) {
  std::string line = " " + key + "=\"";
  char number[32];
  for (const double value : values) {
    std::snprintf(number, sizeof number, "%.9g ", value);
    line += number;
  }
  return line + "\"";
}

std::string place(const Pose& pose) {
  const Eigen::Quaterniond q(pose.linear());
  const Eigen::Vector3d at = pose.translation();
  return text("pos", {at.x(), at.y(), at.z()}) + text("quat", {q.w(), q.x(), q.y(), q.z()});
}

/// A geom of any kind, thin or thick, 1 to 50 cm, sometimes with a margin; some collide with others in one bit only.
std::string random_geom() {
  static constexpr const char* const kTypes[] = {"sphere", "capsule", "ellipsoid", "cylinder", "box"};
  const auto length = [] { return 0.005 * pick(1, pick(0, 3) == 0 ? 50 : 10); };
  return std::string("<geom type=\"") + kTypes[pick(0, 4)] + "\"" + place(fakes::random_pose(0.1, 3)) +
         text("size", {length(), length(), length()}) + text("margin", {0.01 * pick(0, 2)}) + " contype=\"" +
         std::to_string(pick(0, 3)) + "\" conaffinity=\"" + std::to_string(pick(0, 3)) + "\"/>";
}

/// A floor, fixed objects, free bodies and chains of two links.
std::string random_scene() {
  std::string scene = "<mujoco><compiler angle=\"radian\"/><size nconmax=\"2000\" njmax=\"100\"/><option";
  scene += pick(0, 3) == 0 ? text("o_margin", {0.03}) + "><flag override=\"enable\"/></option>" : "/>";
  scene += "<worldbody><geom type=\"plane\" size=\"2 2 0.1\" pos=\"0 0 -0.3\"/>";
  for (int i = 0; i < kBodies; ++i) {
    scene += "<body" + place(fakes::random_pose(0.4, 3)) + ">" + random_geom();
    const int kind = pick(0, 2);
    if (kind == 0) scene += "<freejoint/>";
    if (kind == 1)
      scene += "<joint type=\"hinge\"/><body" + place(fakes::random_pose(0.1, 3)) + ">" +
               (pick(0, 1) == 0 ? "<joint type=\"hinge\"/>" : "") + random_geom() + "</body>";
    scene += "</body>";
  }
  return scene + "</worldbody></mujoco>";
}

using Contact = std::tuple<int, int, double, double, double, double>;  // geoms, distance, place

std::vector<Contact> contacts(const mjModel& model, mjfConFilt filter) {
  const Data data = make_data(model);
  mjcb_contactfilter = filter;
  mj_kinematics(&model, data.get());
  mj_comPos(&model, data.get());
  mj_collision(&model, data.get());
  mjcb_contactfilter = nullptr;
  std::vector<Contact> found;
  for (int i = 0; i < data->ncon; ++i) {
    const mjContact& one = data->contact[i];
    found.emplace_back(one.geom1, one.geom2, one.dist, one.pos[0], one.pos[1], one.pos[2]);
  }
  return found;
}

TEST(ContactFilter, FindsTheContactsThatMujocoFindsWithoutIt) {
  std::size_t all = 0;
  check_property(kCases, [&all] {
    const task_test::ScratchFolder scratch;
    const Model model = load_model(compose_texts(scratch, random_scene()));
    const auto expected = contacts(*model, nullptr);
    RC_ASSERT(contacts(*model, cannot_touch) == expected);
    all += expected.size();
  });
  EXPECT_GT(all, 0u);
}

TEST(ContactFilter, OmitsGeomsBesideALongOne) {
  const task_test::ScratchFolder scratch;
  const Model model = load_model(compose_texts(scratch, R"(<mujoco><worldbody>
    <geom name="belt" type="box" size="1 0.2 0.01"/>
    <body pos="0.5 0 0.4"><freejoint/><geom name="above" size="0.05"/></body>
    <body pos="0.5 0 0.055"><freejoint/><geom name="near" size="0.05"/></body></worldbody></mujoco>)"));
  const Data data = make_data(*model);
  mj_kinematics(model.get(), data.get());
  const auto geom = [&](const char* name) { return mj_name2id(model.get(), mjOBJ_GEOM, name); };
  EXPECT_EQ(cannot_touch(model.get(), data.get(), geom("belt"), geom("above")), 1);
  EXPECT_EQ(cannot_touch(model.get(), data.get(), geom("above"), geom("belt")), 1);
  EXPECT_EQ(cannot_touch(model.get(), data.get(), geom("belt"), geom("near")), 0);
}

}  // namespace
}  // namespace mrroc::sim::contact_filter_test
