#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "cli/panel/beat.hpp"
#include "cli/panel/browser.hpp"
#include "cli/panel/camera_pictures.hpp"
#include "cli/panel/page_files.hpp"
#include "cli/panel/panel_access.hpp"
#include "cli/panel/tls_door.hpp"

struct mg_connection;
struct mg_context;

namespace mrroc::cli {

struct PanelAddress {
  std::string address = "127.0.0.1";
  int port = 0;                       ///< 0: any free one
  std::filesystem::path certificate;  ///< PEM file with certificate and key: TLS; empty: without
};

/// The panel's web server: the page's files and one WebSocket for each browser, all below a path with a token.
/// docs/reference/panel.md. civetweb's threads call it; a browser that is slow or does not read keeps only its own.
class PanelServer {
 public:
  static constexpr std::size_t kMaxBrowsers = 24;

  /// `run`: the run's socket, to which every browser gets a connection; `pictures` outlives the server. Throws
  /// std::runtime_error when it cannot listen there.
  PanelServer(const PanelAddress& address, std::filesystem::path run, std::map<std::string, PageFile> files,
              CameraPictures& pictures);
  ~PanelServer();
  PanelServer(const PanelServer&) = delete;
  PanelServer& operator=(const PanelServer&) = delete;

  std::string url(PanelRight right) const { return access_.url(right); }
  const Beat& beat() const noexcept { return beat_; }
  std::size_t browsers() const;
  /// A line for every browser; with `keep` also for those that join later, as one of the last kKept.
  void publish(const std::string& line, bool keep);
  /// A state of this kind for every browser; only the newest counts.
  void publish_state(const std::string& kind, const std::string& line);

 private:
  struct Callbacks;
  static constexpr std::size_t kKept = 200;

  int answer(mg_connection& connection) const;
  bool admit(const mg_connection& connection) const;
  void join(mg_connection& connection);
  bool receive(const mg_connection& connection, int bits, std::string_view data);
  void leave(const mg_connection& connection);

  std::filesystem::path run_;
  std::map<std::string, PageFile> files_;
  CameraPictures& pictures_;
  PanelAccess access_;
  Beat beat_;
  mutable std::mutex mutex_;
  std::map<const mg_connection*, std::shared_ptr<Browser>> browsers_;
  std::deque<std::string> kept_;
  std::string problem_;  ///< first message of civetweb
  mg_context* context_ = nullptr;
  std::optional<TlsDoor> door_;
};

}  // namespace mrroc::cli
