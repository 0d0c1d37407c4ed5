#include "sim/errors/misplaced_links.hpp"

#include <algorithm>
#include <utility>

#include "sim/errors/true_errors.hpp"
#include "sim/scene/placement.hpp"

namespace mrroc::sim {

namespace {

bool is_link(const Element& body) {
  return std::any_of(body.children.begin(), body.children.end(), [](const Element& child) {
    return child.name == "joint" && child.value_or("type", "hinge") != "free";
  });
}

}  // namespace

void misplace_links(std::vector<Element>& world, const config::ErrorsEntry& errors, const std::string& robot) {
  for (Element& body : world) {
    if (body.name != "body") continue;
    misplace_links(body.children, errors, robot);
    if (!is_link(body)) continue;
    const std::string link = body.value_or("name", "").substr(robot.size() + 1);
    // a frame around the body keeps the MJCF's pose in whatever form it is given
    Element frame = take_frame(body);
    set_pose(body, error_of_link(errors, robot, link));
    frame.children.push_back(std::move(body));
    body = std::move(frame);
  }
}

}  // namespace mrroc::sim
