#include "edp/check/robot_check.hpp"

#include "config/robot_parameters_file.hpp"
#include "config/text/message_text.hpp"
#include "edp/check/model_check.hpp"
#include "edp/check/urdf_check.hpp"

namespace mrroc::edp {

void check_robot(const RobotModels& models, const std::string& type) {
  const auto file = config::Table::load(config::robot_file(type, type + ".toml"));
  const std::string& read = models.front()->parameters().type;
  if (read != type) file.fail("type", config::in_quotes(read), config::in_quotes(type) + ", as its folder");
  check_models(models, file);
  const auto urdf = config::robot_file(type, type + ".urdf");
  if (std::filesystem::exists(urdf)) check_urdf(*models.front(), urdf);
}

}  // namespace mrroc::edp
