#include "cli/robot/import/mesh_store.hpp"

#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

#include "cli/robot/import/names.hpp"
#include "command/write_file.hpp"
#include "config/table.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::cli {

namespace fs = std::filesystem;
using config::ConfigurationError;

namespace {

constexpr std::size_t kStlHeader = 80;
constexpr double kFlat = 1e-3;  // smallest edge of a part's box, of the largest one: MuJoCo refuses flat meshes

std::optional<Eigen::Vector4d> colour_of(const aiMaterial& material) {
  aiColor4D colour;
  if (material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) != aiReturn_SUCCESS) return {};
  return Eigen::Vector4d(colour.r, colour.g, colour.b, 1).cwiseMax(0).cwiseMin(1);
}

template <class Value>
void append_bytes(std::string& text, const Value& value) {
  text.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

struct MeshStore::Surface {
  std::vector<Triangle> triangles;
  std::optional<Eigen::Vector4d> colour;

  Eigen::AlignedBox3d box() const {
    Eigen::AlignedBox3d box;
    for (const Triangle& triangle : triangles)
      for (const Eigen::Vector3f& corner : triangle) box.extend(corner.cast<double>());
    return box;
  }
  bool is_flat() const {
    const Eigen::Vector3d sizes = box().sizes();
    return sizes.minCoeff() <= kFlat * sizes.maxCoeff();
  }
  /// The file's bytes: little-endian, as the machine.
  std::string stl() const {
    std::string text(kStlHeader, ' ');
    append_bytes(text, static_cast<std::uint32_t>(triangles.size()));
    for (const Triangle& triangle : triangles) {
      const Eigen::Vector3f normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
      for (const Eigen::Vector3f& vector : {normal, triangle[0], triangle[1], triangle[2]})
        for (const float number : {vector.x(), vector.y(), vector.z()}) append_bytes(text, number);
      append_bytes(text, std::uint16_t{0});
    }
    return text;
  }
};

std::vector<MeshStore::Surface> MeshStore::read(const fs::path& source, const fs::path& urdf, int line) {
  Assimp::Importer importer;
  // the axes of the file are those of the URDF's link; its unit counts
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* const scene = importer.ReadFile(
      source.string(), aiProcess_Triangulate | aiProcess_PreTransformVertices | aiProcess_SortByPType);
  const auto refuse = [&](const std::string& problem) {
    throw ConfigurationError(urdf, line, "<mesh> filename", source.string() + ": " + problem,
                             "a mesh of triangles: STL, OBJ, Collada");
  };
  if (scene == nullptr) refuse(config::in_quotes(importer.GetErrorString()));
  std::vector<Surface> surfaces;
  for (const aiMesh* mesh : std::span(scene->mMeshes, scene->mNumMeshes)) {
    Surface surface;
    if (mesh->mMaterialIndex < scene->mNumMaterials)
      surface.colour = colour_of(*scene->mMaterials[mesh->mMaterialIndex]);
    for (const aiFace& face : std::span(mesh->mFaces, mesh->mNumFaces)) {
      if (face.mNumIndices != 3) continue;
      Triangle triangle;
      for (std::size_t i = 0; i < 3; ++i) {
        const aiVector3D& corner = mesh->mVertices[face.mIndices[i]];
        triangle[i] = {corner.x, corner.y, corner.z};
        if (!triangle[i].allFinite()) refuse("has a coordinate that is not finite");
      }
      surface.triangles.push_back(triangle);
    }
    if (!surface.triangles.empty()) surfaces.push_back(std::move(surface));
  }
  if (surfaces.empty()) refuse("has no triangles");
  return surfaces;
}

MeshPart MeshStore::write(const Surface& surface, const std::string& stem) {
  std::string content = surface.stl();
  MeshPart part{"", surface.box(), surface.colour};
  const auto known = written_.find(content);
  if (known != written_.end()) {
    part.name = known->second;
    return part;
  }
  const int count = ++names_[stem];
  part.name = count == 1 ? stem : stem + "_" + std::to_string(count);
  fs::create_directories(folder_);
  command::write_file(folder_ / (part.name + ".stl"), std::as_bytes(std::span(content)));
  written_.emplace(std::move(content), part.name);
  return part;
}

const std::vector<MeshPart>& MeshStore::add(const fs::path& source, bool as_one, const fs::path& urdf, int line) {
  const auto [place, is_new] = added_.try_emplace({fs::weakly_canonical(source), as_one});
  if (!is_new) return place->second;
  std::vector<Surface> surfaces = read(source, urdf, line);
  std::sort(surfaces.begin(), surfaces.end(),
            [](const Surface& a, const Surface& b) { return a.triangles.size() > b.triangles.size(); });
  // a flat part, a label for example, becomes part of the largest one
  for (std::size_t i = surfaces.size(); i-- > 1;) {
    if (!as_one && !surfaces[i].is_flat()) continue;
    std::vector<Triangle>& largest = surfaces.front().triangles;
    largest.insert(largest.end(), surfaces[i].triangles.begin(), surfaces[i].triangles.end());
    surfaces.erase(surfaces.begin() + static_cast<std::ptrdiff_t>(i));
  }
  const std::string stem = plain_name(source.stem().string());
  for (const Surface& surface : surfaces) {
    for (std::size_t first = 0; first < surface.triangles.size(); first += kMaxTriangles) {
      const auto begin = surface.triangles.begin() + static_cast<std::ptrdiff_t>(first);
      const std::size_t count = std::min(kMaxTriangles, surface.triangles.size() - first);
      place->second.push_back(write({{begin, begin + static_cast<std::ptrdiff_t>(count)}, surface.colour}, stem));
    }
  }
  return place->second;
}

}  // namespace mrroc::cli
