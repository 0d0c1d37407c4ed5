#pragma once

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mrroc::cli {

/// One STL file in a robot's folder.
struct MeshPart {
  std::string name;                       ///< of the file in meshes/, without extension
  Eigen::AlignedBox3d box;                ///< of its vertices, without scale
  std::optional<Eigen::Vector4d> colour;  ///< of the material in the source
};

/// Converts meshes of any format that assimp reads into binary STL files of a robot's folder: only such are read by
/// MuJoCo 2.2 without doubt. Files of the same content are written once. Configuration time only.
class MeshStore {
 public:
  static constexpr std::size_t kMaxTriangles = 190000;  ///< of one file; MuJoCo 2.2 reads up to 200000

  /// `folder`: made with the first mesh.
  explicit MeshStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The parts of `source`, one for each material, of more for very many triangles; `as_one`: without regard to
  /// materials. `urdf` and `line` name the reference in messages. Throws config::ConfigurationError: assimp cannot read
  /// the file, it has no triangles, a coordinate that is not finite. Throws SystemError when a part cannot be written.
  const std::vector<MeshPart>& add(const std::filesystem::path& source, bool as_one, const std::filesystem::path& urdf,
                                   int line);

 private:
  using Triangle = std::array<Eigen::Vector3f, 3>;
  struct Surface;
  static std::vector<Surface> read(const std::filesystem::path& source, const std::filesystem::path& urdf, int line);
  MeshPart write(const Surface& surface, const std::string& stem);

  std::filesystem::path folder_;
  std::map<std::pair<std::filesystem::path, bool>, std::vector<MeshPart>> added_;
  std::map<std::string, std::string> written_;  // content, name
  std::map<std::string, int> names_;            // how often a stem was used
};

}  // namespace mrroc::cli
