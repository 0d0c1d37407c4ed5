#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cli/robot/import/findings.hpp"
#include "cli/robot/import/mesh_paths.hpp"
#include "cli/robot/import/mesh_store.hpp"
#include "cli/robot/import/urdf_bodies.hpp"
#include "sim/scene/xml.hpp"

namespace mrroc::cli {

/// The shapes of links as geoms of an MJCF. Visible ones are in group 2 and collide with nothing; colliding ones are in
/// group 3, which pictures do not show. A link with shapes of one kind only uses them for both. Configuration time
/// only.
class LinkShapes {
 public:
  /// `arm_length`: the sum of the distances of the joints, m. The references must outlive this object.
  LinkShapes(std::filesystem::path urdf, double arm_length, MeshPaths& paths, MeshStore& meshes, Findings& findings)
      : urdf_(std::move(urdf)), arm_length_(arm_length), paths_(paths), meshes_(meshes), findings_(findings) {}

  /// Converts the meshes of a link. Warns of shapes that are much larger than the arm. Throws
  /// config::ConfigurationError as MeshPaths and MeshStore.
  void add(const UrdfBody& body);

  /// The geoms of a link that was added, in the link's frame.
  const std::vector<sim::Element>& geoms(const std::string& link) const { return links_.at(link).geoms; }
  /// The box around the link's colliding shapes, else its visible ones; empty: no shapes, or they are too large.
  const Eigen::AlignedBox3d& box(const std::string& link) const { return links_.at(link).box; }
  /// The elements `mesh` of the section `asset`.
  const std::vector<sim::Element>& assets() const noexcept { return assets_; }
  /// For every reference to a mesh in the URDF, the name of its first file in meshes/.
  const std::map<std::string, std::string>& files() const noexcept { return files_; }

 private:
  struct Link {
    std::vector<sim::Element> geoms;
    Eigen::AlignedBox3d box;
  };
  enum class Use { visible, colliding, both };
  void add_shape(const UrdfBody& body, const UrdfShape& shape, Use use, Link& link);
  void add_mesh(const UrdfBody& body, const UrdfShape& shape, Use use, Link& link);
  bool has_size_of_arm(const UrdfBody& body, const UrdfShape& shape, const Eigen::AlignedBox3d& box);
  std::string asset_of(const MeshPart& part, const Eigen::Vector3d& scale);

  std::filesystem::path urdf_;
  double arm_length_;
  MeshPaths& paths_;
  MeshStore& meshes_;
  Findings& findings_;
  std::map<std::string, Link> links_;
  std::vector<sim::Element> assets_;
  std::map<std::string, std::string> asset_names_;  // by file and scale
  std::map<std::string, int> asset_counts_;         // of each file
  std::map<std::string, std::string> files_;
};

}  // namespace mrroc::cli
