#include "cli/panel/browser.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "cli/operator/socket/operator_socket.hpp"

namespace mrroc::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kPoll = 1000;  // ms

/// Refused before it reaches the run, like a refusal of the run.
std::string refusal(const Json& request, const char* reason, const std::string& text, const std::string& expected) {
  Json json;
  if (request.is_object() && request.contains("id") && request["id"].is_number_integer()) json["id"] = request["id"];
  json.update(Json{{"ok", false}, {"reason", reason}, {"text", text}});
  if (!expected.empty()) json["expected"] = expected;
  return json.dump();
}

}  // namespace

Browser::Browser(const std::filesystem::path& run, PanelRight right, const Beat& beat, Send send)
    : run_(run), right_(right), beat_(beat), send_(std::move(send)), wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (wake_ < 0) throw std::runtime_error("no descriptor for a browser");
  writer_ = std::thread([this] { write(); });
}

Browser::~Browser() {
  ended_ = true;
  wake();
  writer_.join();
  close(wake_);
}

void Browser::receive(std::string_view message) {
  if (message.size() > OperatorSocket::kMaxLine) {
    publish(refusal({}, "malformed", "the message is too long",
                    "at most " + std::to_string(OperatorSocket::kMaxLine) + " bytes"));
    return;
  }
  Json request = Json::parse(message, nullptr, false);
  if (!request.is_object()) {
    publish(refusal({}, "malformed", "the message is not a JSON object", R"({"verb":"...", ...})"));
    return;
  }
  const auto found = request.find("verb");
  const std::string verb = found != request.end() && found->is_string() ? found->get<std::string>() : "";
  if (verb == "echo") {
    publish(refusal(request, "not_allowed", "the panel sends every event already", ""));
    return;
  }
  if (right_ != PanelRight::command && verb != "status") {
    publish(refusal(request, "read_only", "this browser may watch only", "the panel's other URL"));
    return;
  }
  if (verb == "record") {  // a browser, perhaps on another machine, names no folder of this one
    const auto file = request.find("file");
    if (file != request.end() && file->is_string() && file->get<std::string>().find('/') != std::string::npos) {
      publish(refusal(request, "invalid_argument", "file: a browser cannot choose the folder", "a name without '/'"));
      return;
    }
  }
  if (verb == "jog") {
    const auto number = request.find("beat");
    if (number == request.end() || !number->is_number_integer() || !beat_.is_recent(number->get<std::int64_t>())) {
      publish(refusal(request, "stale", "the request comes too late", "\"beat\", the newest number received"));
      return;
    }
    request.erase("beat");
  }
  if (!run_.send_line(request.dump(-1, ' ', false, Json::error_handler_t::replace))) wake();
}

void Browser::publish(const std::string& line) {
  outbox_.add(line);
  wake();
}

void Browser::publish_state(const std::string& kind, const std::string& line) {
  outbox_.replace(kind, line);
  wake();
}

void Browser::wake() noexcept {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(wake_, &one, sizeof one);
}

void Browser::write() {
  bool connected = true;
  while (!ended_ && !outbox_.overflowed()) {
    pollfd entries[2]{{wake_, POLLIN, 0}, {connected ? run_.descriptor() : -1, POLLIN, 0}};
    ::poll(entries, 2, kPoll);
    std::uint64_t count = 0;
    [[maybe_unused]] const ssize_t size = ::read(wake_, &count, sizeof count);
    std::vector<std::string> replies;
    if (connected) connected = run_.read_lines(replies);
    for (const std::string& line : replies) outbox_.add(line);
    for (const std::string& line : outbox_.take())
      if (ended_ || !send_(line)) return;
  }
}

}  // namespace mrroc::cli
