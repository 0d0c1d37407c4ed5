#include "cli/robot/import/link_shapes.hpp"

#include <algorithm>

#include "cli/robot/import/mjcf_elements.hpp"

namespace mrroc::cli {

namespace {

constexpr double kMuchLarger = 10;     // a link's shape, of the arm's length
constexpr double kShortestArm = 0.05;  // m
constexpr double kThousand = 100;      // from here on, millimetres are likely

const char* class_of(bool visible, bool colliding) {
  if (visible) return colliding ? nullptr : "visual";
  return "collision";
}

Eigen::AlignedBox3d box_of(const UrdfShape& shape) {
  Eigen::Vector3d half = shape.size / 2;
  if (shape.kind != UrdfShape::Kind::box) {
    const double caps = shape.kind == UrdfShape::Kind::cylinder ? 0 : shape.size[0];
    half = {shape.size[0], shape.size[0], shape.size[1] / 2 + caps};
  }
  return {-half, half};
}

void set_form(const UrdfShape& shape, Attributes& attributes) {
  const auto set = [&](const char* type, const std::string& size) {
    attributes.emplace_back("type", type);
    attributes.emplace_back("size", size);
  };
  const double half = shape.size[1] / 2;
  switch (shape.kind) {
    case UrdfShape::Kind::box:
      return set("box", mjcf_numbers(Eigen::Vector3d(shape.size / 2)));
    case UrdfShape::Kind::cylinder:
      return set("cylinder", mjcf_numbers(Eigen::Vector2d(shape.size[0], half)));
    case UrdfShape::Kind::capsule:
      return set("capsule", mjcf_numbers(Eigen::Vector2d(shape.size[0], half)));
    default:
      return set("sphere", config::number_text(shape.size[0]));
  }
}

}  // namespace

void LinkShapes::add(const UrdfBody& body) {
  Link& link = links_[body.name];
  const bool apart = !body.visuals.empty() && !body.collisions.empty();
  for (const UrdfShape& shape : body.collisions) add_shape(body, shape, apart ? Use::colliding : Use::both, link);
  const Eigen::AlignedBox3d colliding = link.box;
  for (const UrdfShape& shape : body.visuals) add_shape(body, shape, apart ? Use::visible : Use::both, link);
  if (apart) link.box = colliding;
}

void LinkShapes::add_shape(const UrdfBody& body, const UrdfShape& shape, Use use, Link& link) {
  if (shape.kind == UrdfShape::Kind::mesh) return add_mesh(body, shape, use, link);
  Attributes attributes;
  if (const char* name = class_of(use != Use::colliding, use != Use::visible)) attributes.emplace_back("class", name);
  set_form(shape, attributes);
  add_mjcf_pose(attributes, shape.origin);
  if (use != Use::colliding && shape.colour) attributes.emplace_back("rgba", mjcf_numbers(*shape.colour));
  link.geoms.push_back(mjcf_element("geom", attributes));
  const Eigen::AlignedBox3d box = box_of(shape);
  if (has_size_of_arm(body, shape, box)) link.box.extend(box.transformed(shape.origin));
}

void LinkShapes::add_mesh(const UrdfBody& body, const UrdfShape& shape, Use use, Link& link) {
  const std::filesystem::path source = paths_.find(shape.mesh, shape.line);
  Eigen::AlignedBox3d whole;
  for (const MeshPart& part : meshes_.add(source, use != Use::visible, urdf_, shape.line)) {
    Attributes attributes;
    if (const char* name = class_of(use != Use::colliding, use != Use::visible)) attributes.emplace_back("class", name);
    attributes.emplace_back("type", "mesh");
    attributes.emplace_back("mesh", asset_of(part, shape.scale));
    add_mjcf_pose(attributes, shape.origin);
    const auto& colour = shape.colour ? shape.colour : part.colour;
    if (use != Use::colliding && colour) attributes.emplace_back("rgba", mjcf_numbers(*colour));
    link.geoms.push_back(mjcf_element("geom", attributes));
    files_.try_emplace(shape.mesh, part.name);
    whole.extend(
        Eigen::AlignedBox3d(part.box).transformed(Eigen::Affine3d(Eigen::Scaling(Eigen::Vector3d(shape.scale)))));
  }
  if (has_size_of_arm(body, shape, whole)) link.box.extend(whole.transformed(shape.origin));
}

bool LinkShapes::has_size_of_arm(const UrdfBody& body, const UrdfShape& shape, const Eigen::AlignedBox3d& box) {
  const double ratio = box.sizes().maxCoeff() / std::max(arm_length_, kShortestArm);
  if (ratio < kMuchLarger) return true;
  findings_.warn("the shape is " + config::number_text(std::round(ratio)) +
                     " times as large as the arm is long: check the scale of the mesh" +
                     (ratio > kThousand ? ", perhaps millimetres: scale=\"0.001 0.001 0.001\"" : ""),
                 "link '" + body.name + "'", shape.line);
  return false;
}

std::string LinkShapes::asset_of(const MeshPart& part, const Eigen::Vector3d& scale) {
  const std::string scale_text = mjcf_numbers(scale);
  const auto [place, is_new] = asset_names_.try_emplace(part.name + " " + scale_text);
  if (!is_new) return place->second;
  const int count = ++asset_counts_[part.name];
  place->second = count == 1 ? part.name : part.name + "-scale" + std::to_string(count);
  Attributes attributes{{"name", place->second}, {"file", part.name + ".stl"}};
  if (scale != Eigen::Vector3d::Ones()) attributes.emplace_back("scale", scale_text);
  assets_.push_back(mjcf_element("mesh", attributes));
  return place->second;
}

}  // namespace mrroc::cli
