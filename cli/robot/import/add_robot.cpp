#include "cli/robot/import/add_robot.hpp"

#include <spdlog/fmt/fmt.h>

#include <set>

#include "cli/robot/import/demo_command.hpp"
#include "cli/robot/import/demo_files.hpp"
#include "cli/robot/import/home.hpp"
#include "cli/robot/import/import_checks.hpp"
#include "cli/robot/import/names.hpp"
#include "cli/robot/import/new_folder.hpp"
#include "cli/robot/import/robot_mjcf.hpp"
#include "cli/robot/import/robot_toml.hpp"
#include "cli/robot/import/urdf_copy.hpp"
#include "config/resources.hpp"
#include "config/table.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::cli {

namespace fs = std::filesystem;
using config::ConfigurationError;
using config::in_quotes;

namespace {

constexpr double kArmatureOfInertia = 0.1, kLeastArmature = 1e-3;

/// Of an imported type: what an import may replace.
bool is_made(const std::string& name, const std::string& type) {
  const std::set<std::string> made{type + ".toml",  type + ".urdf", type + ".xml", "demo.toml",
                                   "external.toml", "demo.xml",     "meshes"};
  return made.contains(name);
}

/// Throws when it is no folder, or holds anything that an import does not make, or one of its inputs: it would be lost.
void check_replaced(const fs::path& folder, const std::string& type, const AddRequest& request) {
  std::error_code none;
  if (!fs::is_directory(folder))
    throw ConfigurationError(folder, 0, "--replace", "is no folder", "the folder of an imported type");
  std::set<std::string> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) found.insert(entry.path().filename());
  for (const std::string& name : found)
    if (!is_made(name, type))
      throw ConfigurationError(folder, 0, "--replace", "holds " + in_quotes(name) + ", which no import makes",
                               "the folder of an imported type and nothing else");
  for (const fs::path& input : {request.urdf, request.limits})
    for (fs::path above = fs::weakly_canonical(input, none); !input.empty() && above.has_relative_path();
         above = above.parent_path())
      if (fs::equivalent(above, folder, none))
        throw ConfigurationError(input, 0, "--replace", "lies in the folder that is replaced", "a file elsewhere");
}

/// The type's name and folder. Throws for a name that is not one, a folder that exists, an installed type.
fs::path target_of(const AddRequest& request, const std::string& type) {
  if (type != type_name(type))
    throw ConfigurationError(request.urdf, 0, "--name", in_quotes(type) + " is not the name of a type",
                             "letters, digits and '_', first a letter");
  fs::path folder = fs::absolute(request.into.empty() ? config::user_share() / "robots" : request.into) / type;
  if (fs::exists(folder) && !request.replace)
    throw ConfigurationError(folder, 0, "", "exists", "another --name, or --replace");
  if (fs::exists(folder)) check_replaced(folder, type, request);
  const fs::path installed = config::type_file("robots", type, type + ".toml");
  std::error_code none;
  if (fs::is_regular_file(installed, none) && !fs::equivalent(installed.parent_path(), folder, none))
    throw ConfigurationError(request.urdf, 0, "--name",
                             in_quotes(type) + " is the type in " + installed.parent_path().string(), "another name");
  return folder;
}

/// Inertia of rotor and gear, which no URDF has.
std::map<std::string, double> armature_of(const std::vector<AxisLimits>& axes, const JointVector& inertia) {
  std::map<std::string, double> armature;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    double largest = 0;
    for (std::size_t j = 0; j < axes.size(); ++j)
      if (axes[j].slides == axes[i].slides) largest = std::max(largest, inertia[static_cast<Eigen::Index>(j)]);
    const double own = inertia[static_cast<Eigen::Index>(i)];
    armature[axes[i].name] = std::max(kArmatureOfInertia * own, kLeastArmature * largest);
  }
  return armature;
}

/// One import: the parts in the order in which they are made.
class Import {
 public:
  explicit Import(const AddRequest& request)
      : request_(request),
        findings_(request.urdf),
        urdf_(edp::Urdf::load(request.urdf, edp::Urdf::Limits::optional)),
        bodies_(read_urdf_bodies(request.urdf, findings_)),
        arm_(arm_of(urdf_, request.base, request.tip)),
        given_(request.limits.empty() ? LimitsFile() : LimitsFile::load(request.limits)),
        type_(request.name.empty() ? type_name(bodies_.robot) : request.name),
        target_(target_of(request, type_)),
        axes_(limits_of_axes(urdf_, arm_, given_, request.accept_guesses, findings_)),
        reach_(reach_of(arm_, axes_)),
        kind_(request.drives == "torque" ? DriveKind::torque : DriveKind::itself) {
    check_reach(arm_, urdf_, reach_, request.reach);
    note_nearly_parallel(arm_, findings_);
  }

  std::string run() {
    NewFolder folder(target_);
    MeshPaths paths(request_.urdf, findings_);
    MeshStore meshes(folder.path() / "meshes");
    LinkShapes shapes(request_.urdf, length_of(arm_), paths, meshes, findings_);
    const RobotMjcf mjcf(urdf_, bodies_, arm_, axes_, shapes, findings_);
    const kinematics::ChainModel model = chain_model_of(arm_, axes_);
    folder.write("demo.xml", demo_scene(type_, reach_));
    const auto write_mjcf = [&](const MjcfExtras& extras) {
      folder.write(type_ + ".xml", mjcf_header() + sim::write(mjcf.mjcf(type_, extras)).text);
    };
    const auto world = [&] {
      return ArmWorld(folder.path() / "demo.xml", demo_height(reach_), folder.path() / (type_ + ".xml"), names());
    };
    MjcfExtras extras;
    write_mjcf(extras);
    ArmWorld draft = world();
    extras.excluded = always_touching(axes_, draft);
    const JointVector home = find_home(
        model, axes_, [&](const JointVector& joints) { return is_free_around(joints, axes_, extras.excluded, draft); });
    for (const BodyPair& pair : draft.contacts(home))
      if (!pair.first.empty()) extras.excluded.insert(pair);
    extras.armature = armature_of(axes_, draft.inertia(home));
    const std::vector<AxisDrive> drives = drives_of(axes_, draft);
    note_pairs(extras);
    note_drives(kind_, axes_, request_.urdf, findings_);
    write_mjcf(extras);
    ArmWorld checked = world();
    check_model(arm_, axes_, folder.path() / (type_ + ".xml"), checked);
    folder.write(type_ + ".toml",
                 robot_toml(type_, request_.urdf.filename().string(), arm_, axes_, kind_, drives, home));
    folder.write(type_ + ".urdf", urdf_copy(request_.urdf, shapes.files()));
    folder.write("demo.toml", demo_deployment(type_, reach_));
    folder.write("external.toml", external_deployment(type_, reach_));
    folder.keep();
    return report(model);
  }

 private:
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const AxisLimits& axis : axes_) names.push_back(axis.name);
    return names;
  }

  std::string mjcf_header() const {
    return "<!-- Made by mrroc robot add from " + plain_name(request_.urdf.filename().string()) +
           ". Root \"base\" is the arm's base link. -->\n";
  }

  void note_pairs(const MjcfExtras& extras) {
    for (const auto& [one, other] : extras.excluded)
      findings_.guess("links that touch by design or at home do not collide", fmt::format("{} and {}", one, other), 0);
  }

  std::string report(const kinematics::ChainModel& model) const {
    std::string text = fmt::format("{}: {} axes from link {} to link {}, reach {:.3f} m\n", target_.string(),
                                   axes_.size(), arm_.base, arm_.tip, reach_);
    text += fmt::format("inverse: {}\n", model.closed_form()
                                             ? fmt::format("closed form: {}", name_of(model.closed_form().structure()))
                                             : std::string{"numeric, within the limits"});
    text += findings_.text();
    text += "next: " + demo_command(target_) + "\n";
    return text;
  }

  const AddRequest& request_;
  Findings findings_;
  edp::Urdf urdf_;
  UrdfBodies bodies_;
  UrdfArm arm_;
  LimitsFile given_;
  std::string type_;
  fs::path target_;
  std::vector<AxisLimits> axes_;
  double reach_;
  DriveKind kind_;
};

}  // namespace

std::string add_robot(const AddRequest& request) { return Import(request).run(); }

}  // namespace mrroc::cli
