#pragma once

#include <optional>
#include <string>

#include "cli/operator/socket/run_connection.hpp"
#include "cli/panel/camera_pictures.hpp"
#include "cli/panel/panel_server.hpp"
#include "cli/panel/world_view.hpp"

namespace mrroc::cli {

/// Brings the run's events to the browsers: one stream for all of them, so that a further browser costs the run
/// nothing. States of robots, sensors and the world are asked for only while a browser is there. One thread.
class RunFeed {
 public:
  /// `view` may be null. All outlive it.
  RunFeed(RunConnection& run, WorldView* view, CameraPictures& pictures, PanelServer& server)
      : run_(run), view_(view), pictures_(pictures), server_(server) {}

  /// Serves until the run ends or `stop`, a descriptor, becomes readable.
  void serve(int stop);

 private:
  void pass_on(const std::string& line);
  void beat();
  /// Asks for states when the first browser has come, for none when the last one has left.
  void adapt();

  RunConnection& run_;
  WorldView* view_;
  CameraPictures& pictures_;
  PanelServer& server_;
  std::int64_t beat_ = -1;
  std::optional<bool> watching_;
};

}  // namespace mrroc::cli
