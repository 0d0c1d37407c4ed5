#include "cli/robot/type/type_files.hpp"

#include <algorithm>
#include <stdexcept>

#include "config/resources.hpp"
#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "robots/arm/arm_model.hpp"

namespace mrroc::cli {

ChainType load_chain_type(const std::string& name) {
  const std::vector<std::string> types = config::robot_types();
  if (std::find(types.begin(), types.end(), name) == types.end())
    throw std::invalid_argument("robot type " + config::in_quotes(name) + " is not installed, expected a URDF or " +
                                config::alternatives(types));
  ChainType type;
  type.parameters = config::type_file("robots", name, name + ".toml");
  const config::Table table = config::Table::load(type.parameters);
  if (!table.has("chain"))
    table.fail("chain", "is missing: this type has a program of its own", "a type that mrroc robot add has made");
  const config::Table chain = table.table("chain");
  type.base = chain.text("base");
  type.tip = chain.text("tip");
  type.model = std::dynamic_pointer_cast<const kinematics::ChainModel>(load_arm(type.parameters).front());
  const std::filesystem::path folder = type.parameters.parent_path();
  type.urdf = folder / (name + ".urdf");
  type.mjcf = folder / (name + ".xml");
  type.scene = folder / "demo.xml";
  return type;
}

}  // namespace mrroc::cli
