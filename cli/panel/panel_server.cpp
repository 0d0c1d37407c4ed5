#include "cli/panel/panel_server.hpp"

#include <civetweb.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

namespace mrroc::cli {

namespace {

constexpr int kProtocol = 1;
constexpr int kText = 1, kEnd = 0x80, kOpcode = 0x0f;  // of a WebSocket frame's first byte, RFC 6455

/// Nothing of another server is loaded, and no other page may contain or read this one.
constexpr const char* kHeaders =
    "Cache-Control: no-store\r\nReferrer-Policy: no-referrer\r\nX-Content-Type-Options: nosniff\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\n"
    "Content-Security-Policy: default-src 'self'; img-src 'self' data: blob:; style-src 'self'; connect-src 'self'; "
    "frame-ancestors 'none'; base-uri 'none'; form-action 'none'\r\n";

/// A path "/token/name".
struct Place {
  std::string_view token, name;
  bool whole = false;  ///< with the second '/'
};

Place place_of(const mg_connection& connection) {
  std::string_view path = mg_get_request_info(&connection)->local_uri;
  if (path.starts_with('/')) path.remove_prefix(1);
  const std::size_t end = path.find('/');
  if (end == std::string_view::npos) return {path, "", false};
  return {path.substr(0, end), path.substr(end + 1), true};
}

void send_headers(mg_connection& connection, const char* status, const std::string& type, std::size_t size,
                  const char* more = "") {
  mg_printf(&connection, "HTTP/1.1 %s\r\nContent-Type: %s\r\nContent-Length: %zu\r\nConnection: close\r\n%s%s\r\n",
            status, type.c_str(), size, kHeaders, more);
}

int send_text(mg_connection& connection, const char* status, const std::string& text) {
  send_headers(connection, status, "text/plain; charset=utf-8", text.size() + 1);
  mg_write(&connection, (text + "\n").data(), text.size() + 1);
  return 1;
}

/// Header of a picture: the tick whose state it shows.
constexpr const char* kTickHeader = "Mrroc-Tick";
constexpr std::string_view kPictures = "pictures/", kPng = ".png";

/// "pictures/NAME.png": NAME; else empty.
std::string_view camera_of(std::string_view name) {
  if (!name.starts_with(kPictures) || !name.ends_with(kPng) || name.size() < kPictures.size() + kPng.size()) return "";
  return name.substr(kPictures.size(), name.size() - kPictures.size() - kPng.size());
}

/// The picture, or why it is missing.
int send_picture(mg_connection& connection, const CameraPicture& picture, bool head) {
  if (picture.png.empty()) return send_text(connection, "503 Service Unavailable", picture.reason);
  const std::string tick = std::string{kTickHeader} + ": " + std::to_string(picture.tick) + "\r\n";
  send_headers(connection, "200 OK", "image/png", picture.png.size(), tick.c_str());
  if (!head) mg_write(&connection, picture.png.data(), picture.png.size());
  return 1;
}

bool accepts_gzip(const mg_connection& connection) {
  const char* const encodings = mg_get_header(&connection, "Accept-Encoding");
  return encodings != nullptr && std::string_view{encodings}.find("gzip") != std::string_view::npos;
}

}  // namespace

/// civetweb's functions, with the server as their data.
struct PanelServer::Callbacks {
  static PanelServer& of(void* data) { return *static_cast<PanelServer*>(data); }
  static int request(mg_connection* connection, void* data) { return of(data).answer(*connection); }
  static int connect(const mg_connection* connection, void* data) { return of(data).admit(*connection) ? 0 : 1; }
  static void ready(mg_connection* connection, void* data) { of(data).join(*connection); }
  static int receive(mg_connection* connection, int bits, char* bytes, std::size_t size, void* data) {
    return of(data).receive(*connection, bits, {bytes, size}) ? 1 : 0;
  }
  static void close(const mg_connection* connection, void* data) { of(data).leave(*connection); }
  /// Only the first message is of interest, when the server does not start.
  static int log(const mg_connection* connection, const char* message) {
    void* const server = mg_get_user_data(mg_get_context(connection));
    if (server == nullptr) return 1;
    const std::lock_guard lock(of(server).mutex_);
    if (of(server).problem_.empty()) of(server).problem_ = message;
    return 1;
  }
};

PanelServer::PanelServer(const PanelAddress& address, std::filesystem::path run, std::map<std::string, PageFile> files,
                         CameraPictures& pictures)
    : run_(std::move(run)),
      files_(std::move(files)),
      pictures_(pictures),
      access_(address.address, !address.certificate.empty()) {
  const bool tls = !address.certificate.empty();
  mg_init_library(0);
  const std::string port = tls ? "127.0.0.1:0" : address.address + ":" + std::to_string(address.port);
  // a browser keeps one thread; the others serve files
  const std::string threads = std::to_string(kMaxBrowsers + 8);
  std::vector<const char*> options{
      "listening_ports",      port.c_str(), "num_threads",        threads.c_str(), "enable_websocket_ping_pong", "yes",
      "websocket_timeout_ms", "5000",       "request_timeout_ms", "5000",          "enable_keep_alive",          "no"};
  options.push_back(nullptr);
  mg_callbacks callbacks{};
  callbacks.log_message = Callbacks::log;
  context_ = mg_start(&callbacks, this, options.data());
  mg_server_port ports{};
  if (context_ == nullptr || mg_get_server_ports(context_, 1, &ports) < 1)
    throw std::runtime_error("the panel cannot listen at " + port + (problem_.empty() ? "" : ": " + problem_));
  if (tls) door_.emplace(address.address, address.port, address.certificate, ports.port);
  access_.listen_at(tls ? door_->port() : ports.port);
  mg_set_request_handler(context_, "/", Callbacks::request, this);
  mg_set_websocket_handler(context_, "/*/socket$", Callbacks::connect, Callbacks::ready, Callbacks::receive,
                           Callbacks::close, this);
}

PanelServer::~PanelServer() {
  door_.reset();
  if (context_ != nullptr) mg_stop(context_);
  mg_exit_library();
}

int PanelServer::answer(mg_connection& connection) const {
  const mg_request_info& request = *mg_get_request_info(&connection);
  const bool head = std::string_view{request.request_method} == "HEAD";
  if (!head && std::string_view{request.request_method} != "GET")
    return send_text(connection, "405 Method Not Allowed", "expected GET");
  const Place place = place_of(connection);
  if (!access_.is_own_host(mg_get_header(&connection, "Host")))
    return send_text(connection, "403 Forbidden", "this is not the address that 'mrroc' has printed");
  if (access_.right_of(place.token) == PanelRight::none)
    return send_text(connection, "403 Forbidden", "wrong or missing token: open the URL that 'mrroc' has printed");
  if (!place.whole) {
    const std::string target = "Location: /" + std::string{place.token} + "/\r\n";
    send_headers(connection, "308 Permanent Redirect", "text/plain", 0, target.c_str());
    return 1;
  }
  // no name contains an escaped character
  if (std::string_view{request.request_uri}.find('%') != std::string_view::npos)
    return send_text(connection, "404 Not Found", "no such file");
  if (const std::string_view camera = camera_of(place.name); !camera.empty()) {
    const auto picture = pictures_.picture(camera);
    return picture != nullptr ? send_picture(connection, *picture, head)
                              : send_text(connection, "404 Not Found", "no such camera");
  }
  const auto found = files_.find(place.name.empty() ? "index.html" : std::string{place.name});
  if (found == files_.end()) return send_text(connection, "404 Not Found", "no such file");
  const PageFile& file = found->second;
  const bool compressed = !file.compressed.empty() && accepts_gzip(connection);
  const std::string& content = compressed ? file.compressed : file.content;
  send_headers(connection, "200 OK", file.type, content.size(),
               compressed ? "Content-Encoding: gzip\r\nVary: Accept-Encoding\r\n" : "");
  if (!head) mg_write(&connection, content.data(), content.size());
  return 1;
}

bool PanelServer::admit(const mg_connection& connection) const {
  return access_.right_of(place_of(connection).token) != PanelRight::none &&
         access_.is_own_host(mg_get_header(&connection, "Host")) &&
         access_.is_own_origin(mg_get_header(&connection, "Origin")) && browsers() < kMaxBrowsers;
}

void PanelServer::join(mg_connection& connection) {
  const PanelRight right = access_.right_of(place_of(connection).token);
  const auto send = [&connection](const std::string& message) {
    return mg_websocket_write(&connection, MG_WEBSOCKET_OPCODE_TEXT, message.data(), message.size()) > 0;
  };
  try {
    const auto browser = std::make_shared<Browser>(run_, right, beat_, send);
    browser->publish(nlohmann::ordered_json{{"event", "hello"},
                                            {"panel", kProtocol},
                                            {"version", MRROC_VERSION},
                                            {"deployment", browser->deployment()},
                                            {"pid", browser->pid()},
                                            {"may_command", right == PanelRight::command},
                                            {"client", browser->client()}}
                         .dump());
    const std::lock_guard lock(mutex_);
    for (const std::string& line : kept_) browser->publish(line);
    browsers_.emplace(&connection, browser);
  } catch (const std::exception& error) {
    send(nlohmann::ordered_json{{"event", "gone"}, {"text", error.what()}}.dump());
  }
}

bool PanelServer::receive(const mg_connection& connection, int bits, std::string_view data) {
  if ((bits & kOpcode) != kText)
    return (bits & kOpcode) >= 8 && (bits & kOpcode) != MG_WEBSOCKET_OPCODE_CONNECTION_CLOSE;
  if ((bits & kEnd) == 0) return false;  // no request is so long that it comes in pieces
  std::shared_ptr<Browser> browser;
  {
    const std::lock_guard lock(mutex_);
    const auto found = browsers_.find(&connection);
    if (found != browsers_.end()) browser = found->second;
  }
  if (browser == nullptr) return false;
  browser->receive(data);
  return true;
}

void PanelServer::leave(const mg_connection& connection) {
  std::shared_ptr<Browser> browser;  // ends here, without the lock: its writer may be waiting
  const std::lock_guard lock(mutex_);
  const auto found = browsers_.find(&connection);
  if (found == browsers_.end()) return;
  browser = std::move(found->second);
  browsers_.erase(found);
}

std::size_t PanelServer::browsers() const {
  const std::lock_guard lock(mutex_);
  return browsers_.size();
}

void PanelServer::publish(const std::string& line, bool keep) {
  const std::lock_guard lock(mutex_);
  if (keep) kept_.push_back(line);
  if (kept_.size() > kKept) kept_.pop_front();
  for (const auto& [connection, browser] : browsers_) browser->publish(line);
}

void PanelServer::publish_state(const std::string& kind, const std::string& line) {
  const std::lock_guard lock(mutex_);
  for (const auto& [connection, browser] : browsers_) browser->publish_state(kind, line);
}

}  // namespace mrroc::cli
