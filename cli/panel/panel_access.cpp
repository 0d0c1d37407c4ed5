#include "cli/panel/panel_access.hpp"

#include <sys/random.h>

#include <array>
#include <stdexcept>
#include <utility>

namespace mrroc::cli {

namespace {

constexpr std::size_t kTokenBytes = 16;

std::string random_token() {
  std::array<unsigned char, kTokenBytes> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error("no random numbers from the kernel");
  std::string token;
  for (const unsigned char byte : bytes) {
    token += "0123456789abcdef"[byte >> 4];
    token += "0123456789abcdef"[byte & 15];
  }
  return token;
}

/// Takes the same time wherever they differ.
bool equal(std::string_view a, std::string_view b) noexcept {
  if (a.size() != b.size()) return false;
  unsigned char difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned char>(a[i] ^ b[i]);
  return difference == 0;
}

}  // namespace

PanelAccess::PanelAccess(std::string address, bool tls)
    : address_(std::move(address)), tls_(tls), command_token_(random_token()), watch_token_(random_token()) {}

PanelRight PanelAccess::right_of(std::string_view token) const noexcept {
  if (equal(token, command_token_)) return PanelRight::command;
  return equal(token, watch_token_) ? PanelRight::watch : PanelRight::none;
}

bool PanelAccess::is_own_host(const char* host) const {
  if (host == nullptr) return false;
  const std::string port = ":" + std::to_string(port_);
  return host == address_ + port || (address_.starts_with("127.") && host == "localhost" + port);
}

bool PanelAccess::is_own_origin(const char* origin) const {
  if (origin == nullptr) return false;
  const std::string_view given{origin};
  return given.starts_with(scheme()) && is_own_host(origin + scheme().size());
}

std::string PanelAccess::url(PanelRight right) const {
  const std::string& token = right == PanelRight::command ? command_token_ : watch_token_;
  return scheme() + address_ + ":" + std::to_string(port_) + "/" + token + "/";
}

}  // namespace mrroc::cli
