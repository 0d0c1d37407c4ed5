#include "robots/arm/arm_model.hpp"

#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "config/axis_file.hpp"
#include "config/robot_parameters_file.hpp"
#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "geometry/rigid_motion.hpp"
#include "kinematics/chain_model.hpp"
#include "regulation/regulator_design.hpp"
#include "regulation/servo_loop.hpp"

namespace mrroc {

namespace {

using config::Range;
using config::Table;
using kinematics::ChainJoint;
using kinematics::ChainModel;
using kinematics::SerialChain;

constexpr double kLeastMargin = 20 * std::numbers::pi / 180;  // rad, of a designed loop's phase
constexpr Range kPlace{-100, 100};                            // m
constexpr Range kTurn{-2 * std::numbers::pi, 2 * std::numbers::pi};
constexpr Range kGear{-1e6, 1e6};

struct Geometry {
  std::vector<ChainJoint> joints;
  JointVector gear;
  Pose flange = Pose::Identity();
};

Pose read_frame(const Table& table, std::string_view key) {
  const std::vector<double> values = table.numbers(key, 6);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Range& range = i < 3 ? kPlace : kTurn;
    if (values[i] < range.min || values[i] > range.max)
      table.fail(key, config::number_text(values[i]) + " is out of range",
                 config::expected_number(range) + (i < 3 ? " (m)" : " (rad)"));
  }
  return pose_from_rpy(Eigen::Vector3d(values.data()), Eigen::Vector3d(values.data() + 3));
}

/// What `table` leaves out stays.
void read_joint(const Table& table, ChainJoint& joint, double& gear) {
  if (table.has("frame")) joint.frame = read_frame(table, "frame");
  if (table.has("axis")) {
    const Eigen::Vector3d axis(table.numbers("axis", 3).data());
    if (!(axis.norm() > 0)) table.fail("axis", "has no direction", "a vector that is not zero");
    joint.axis = axis.normalized();
  }
  if (table.has("kind")) joint.slides = table.choice("kind", {"turns", "slides"}) == "slides";
  gear = table.number_or("gear", gear, kGear);
  if (gear == 0) table.fail("gear", "0", "a number that is not 0");
  table.finish();
}

Geometry read_nominal(const Table& table, const RobotParameters& parameters) {
  Geometry geometry;
  geometry.gear = JointVector::Ones(static_cast<Eigen::Index>(parameters.axes.size()));
  table.text("base");
  table.text("tip");
  geometry.flange = read_frame(table, "flange");
  const Table joints = table.table("joints");
  for (const AxisParameters& axis : parameters.axes) {
    const Table joint = joints.table(axis.name);
    for (const char* key : {"frame", "axis"})
      if (!joint.has(key)) joint.fail(key, "missing", "the joint's " + std::string(key));
    ChainJoint& read = geometry.joints.emplace_back();
    read_joint(joint, read, geometry.gear[static_cast<Eigen::Index>(geometry.joints.size()) - 1]);
  }
  joints.finish();
  table.finish();
  return geometry;
}

Geometry read_variant(const Table& table, const RobotParameters& parameters, Geometry geometry) {
  if (table.has("flange")) geometry.flange = read_frame(table, "flange");
  if (const auto joints = table.optional_table("joints")) {
    for (std::size_t i = 0; i < parameters.axes.size(); ++i)
      if (joints->has(parameters.axes[i].name))
        read_joint(joints->table(parameters.axes[i].name), geometry.joints[i],
                   geometry.gear[static_cast<Eigen::Index>(i)]);
    joints->finish();
  }
  table.finish();
  return geometry;
}

/// The numbers of the regulators that the file leaves to the framework, in every set.
void design_regulators(const Table& table, const JointVector& gear, RobotParameters& parameters) {
  for (std::size_t i = 0; i < parameters.axes.size(); ++i) {
    AxisParameters& axis = parameters.axes[i];
    if (!(axis.regulator_bandwidth > 0)) continue;
    const double ratio = gear[static_cast<Eigen::Index>(i)];
    regulation::design_regulator(axis, ratio, config::kRegulatorPeriod);
    for (const double inertia : {axis.inertia_min, axis.inertia_max}) {
      const regulation::ServoLoop loop(axis, regulation::shaft_inertia(axis, inertia, ratio), config::kRegulatorPeriod);
      const regulation::LoopMargins margins = loop.margins();
      if (margins.stable && margins.phase_margin > kLeastMargin) continue;
      table.tables("axes")[i].fail("inertia",
                                   "with a bandwidth of " + config::number_text(axis.regulator_bandwidth) +
                                       " Hz the loop is " + (margins.stable ? "hardly stable" : "unstable") + " at " +
                                       config::number_text(inertia),
                                   "a range with a smaller ratio, or a smaller bandwidth");
    }
    for (RegulatorSet& set : parameters.regulators)
      if (set.axes[i].regulator_bandwidth > 0) set.axes[i] = axis;
  }
}

}  // namespace

RobotModels load_arm(const std::filesystem::path& file) {
  if (file.empty())
    throw config::ConfigurationError({}, 0, "parameters", "missing, and this program serves many types",
                                     "the parameter file of one");
  const Table table = Table::load(file);
  RobotParameters parameters = config::read_robot_parameters(table);
  const Geometry nominal = read_nominal(table.table("chain"), parameters);
  design_regulators(table, nominal.gear, parameters);
  RobotModels models;
  const auto add = [&](const std::string& name, const Geometry& geometry) {
    models.push_back(
        std::make_shared<ChainModel>(name, parameters, SerialChain(geometry.joints, geometry.flange), geometry.gear));
  };
  add("nominal", nominal);
  if (const auto variants = table.optional_table("models")) {
    for (const std::string& name : variants->table_names()) {
      if (name == "nominal" || name.size() > kNameLength)
        variants->fail(name, config::in_quotes(name) + " is not a valid name for another model",
                       "at most " + std::to_string(kNameLength) + " characters, not 'nominal'");
      add(name, read_variant(variants->table(name), parameters, nominal));
    }
  }
  table.finish();
  return models;
}

}  // namespace mrroc
