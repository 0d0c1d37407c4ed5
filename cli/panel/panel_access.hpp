#pragma once

#include <string>
#include <string_view>

namespace mrroc::cli {

/// What a browser may do.
enum class PanelRight { none, watch, command };

/// Who may use the panel: browsers whose URL contains one of two random tokens, one to command, one to watch only; and
/// only pages that this server has sent. A foreign page that a browser of this machine shows knows no token, and its
/// requests have another origin (RFC 6454); a name that resolves to this address is another host. Any thread.
class PanelAccess {
 public:
  /// `address`: where the server listens. Throws std::runtime_error when the kernel gives no random numbers.
  PanelAccess(std::string address, bool tls);
  /// The port, when it is known.
  void listen_at(int port) { port_ = port; }

  PanelRight right_of(std::string_view token) const noexcept;
  /// Of a request's header "Host".
  bool is_own_host(const char* host) const;
  /// Of a request's header "Origin", which every browser sends with a WebSocket.
  bool is_own_origin(const char* origin) const;
  std::string url(PanelRight right) const;

 private:
  std::string scheme() const { return tls_ ? "https://" : "http://"; }

  std::string address_;
  bool tls_;
  int port_ = 0;
  std::string command_token_, watch_token_;
};

}  // namespace mrroc::cli
