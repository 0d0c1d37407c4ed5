#include "cli/panel/run_feed.hpp"

#include <poll.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace mrroc::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kFarewell = 300;  // ms for the last lines to reach the browsers

}  // namespace

void RunFeed::serve(int stop) {
  for (bool connected = true; connected;) {
    adapt();
    pollfd entries[2]{{stop, POLLIN, 0}, {run_.descriptor(), POLLIN, 0}};
    ::poll(entries, 2, server_.beat().remaining());
    if (entries[0].revents != 0) return;
    std::vector<std::string> lines;
    connected = run_.read_lines(lines);
    for (const std::string& line : lines) pass_on(line);
    beat();
  }
  server_.publish(Json{{"event", "gone"}, {"text", "the run has ended"}}.dump(), false);
  pollfd entry{stop, POLLIN, 0};
  ::poll(&entry, 1, kFarewell);
}

void RunFeed::pass_on(const std::string& line) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) return;
  const std::string event = json.value("event", "");
  if (event == "robot" || event == "world") {
    if (view_ != nullptr) view_->take(line);
  }
  if (event == "world") pictures_.take(line);
  if (event == "robot" || event == "reading" || event == "process")
    server_.publish_state(event + "/" + json.value("name", ""), line);
  else if (!event.empty() && event != "world")
    server_.publish(line, event == "message" || (event == "command" && json.value("command", "") != "jog"));
}

void RunFeed::beat() {
  const std::int64_t number = server_.beat().now();
  if (number == beat_) return;
  beat_ = number;
  if (server_.browsers() == 0) return;
  server_.publish_state("beat", Json{{"event", "beat"}, {"number", number}}.dump());
  if (view_ != nullptr && view_->changed()) server_.publish_state("poses", view_->poses());
}

void RunFeed::adapt() {
  const bool wanted = server_.browsers() > 0;
  if (wanted == watching_) return;
  watching_ = wanted;
  run_.send_line(Json{{"verb", "echo"}, {"of", wanted ? "all" : "changes"}}.dump());
}

}  // namespace mrroc::cli
