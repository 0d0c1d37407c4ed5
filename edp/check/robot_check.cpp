#include "edp/check/robot_check.hpp"

#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "edp/check/model_check.hpp"
#include "edp/check/urdf_check.hpp"

namespace mrroc::edp {

void check_robot(const RobotModels& models, const std::string& type, const config::RobotFiles& files) {
  const auto file = config::Table::load(files.parameters);
  const std::string& read = models.front()->parameters().type;
  if (read != type) file.fail("type", config::in_quotes(read), config::in_quotes(type) + ", as its folder");
  check_models(models, file);
  // a chain was made of its URDF, whose links and limits may be others: `mrroc robot check` compares them
  if (!file.has("chain") && std::filesystem::exists(files.urdf)) check_urdf(*models.front(), files.urdf);
}

}  // namespace mrroc::edp
