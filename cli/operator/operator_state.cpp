#include "cli/operator/operator_state.hpp"

#include <spdlog/fmt/fmt.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "command/printable.hpp"
#include "config/clock_names.hpp"
#include "mrroc/errors.hpp"
#include "process/answer_text.hpp"

namespace mrroc::cli {

namespace {

using Json = nlohmann::ordered_json;

/// Bytes of other processes that are not UTF-8 are replaced.
std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

const char* name_of(links::ProcessRole role) noexcept {
  constexpr const char* kNames[] = {"mp", "ecp", "edp", "vsp", "sim"};
  return kNames[static_cast<std::size_t>(role)];
}

const char* name_of(links::ProcessState state) noexcept {
  constexpr const char* kNames[] = {"starting", "ready", "running", "ended", "failed"};
  return kNames[static_cast<std::size_t>(state)];
}

const char* name_of(links::QuestionKind kind) noexcept {
  constexpr const char* kNames[] = {"message", "number", "yes_no", "choice"};
  return kNames[static_cast<std::size_t>(kind)];
}

Json json_of(const links::ProcessStatus& status) {
  Json json{{"name", std::string{status.process.view()}},
            {"role", name_of(status.role)},
            {"state", name_of(status.state)},
            {"pid", status.pid},
            {"tick", status.tick},
            {"instruction", status.instruction},
            {"activity", std::string{status.activity.view()}},
            {"step", status.step},
            {"ticks", status.counters.ticks},
            {"missed_ticks", status.counters.missed_ticks},
            {"late_commands", status.counters.late_commands}};
  if (status.counters.packages > 0)
    json["packages"] =
        Json{{"received", status.counters.packages},        {"lost", status.counters.packages_lost},
             {"doubled", status.counters.packages_doubled}, {"late", status.counters.packages_late},
             {"bunched", status.counters.packages_bunched}, {"skew_p99_us", status.counters.wakeup_p99_us},
             {"skew_max_us", status.counters.wakeup_max_us}};
  if (status.error.code != ErrorCode::none)
    json["error"] = Json{{"code", static_cast<int>(status.error.code)},
                         {"text", std::string{describe(status.error.code)}},
                         {"detail", std::string{status.error.detail.view()}}};
  return json;
}

Json json_of(const OpenQuestion& question) {
  Json json{{"from", question.asker},
            {"number", question.number},
            {"text", std::string{question.question.text.view()}},
            {"kind", name_of(question.question.kind)},
            {"expected", process::expected_answer(question.question)}};
  if (question.question.kind == links::QuestionKind::number) {
    json["minimum"] = question.question.minimum;
    json["maximum"] = question.question.maximum;
  }
  for (std::size_t i = 0; i < question.question.choice_count; ++i)
    json["choices"].push_back(std::string{question.question.choices[i].view()});
  return json;
}

std::string event(const char* name, const Json& data) {
  Json json{{"event", name}};
  json.update(data);
  return dump(json);
}

/// " 0.1 -0.2", or " name=0.1" of an object.
std::string list_of(const Json& values) {
  std::string list;
  for (const auto& [name, value] : values.items()) {
    list += ' ';
    if (values.is_object()) list.append(name).append("=");
    list += value.is_number() ? fmt::format("{:.5g}", value.get<double>()) : "-";
  }
  return list;
}

}  // namespace

std::string to_json(const OperatorState& state) {
  Json json{{"deployment", state.deployment.name},
            {"file", state.deployment.file.string()},
            {"clock", config::name_of(state.deployment.clock)},
            {"servo_period", state.deployment.servo_period},
            {"tick", state.tick},
            {"task", name_of(state.phase)},
            {"speed", state.speed},
            {"emergency_stop", state.emergency_stopped},
            {"commander", state.commander.empty() ? Json{} : Json(state.commander)},
            {"processes", Json::array()},
            {"questions", Json::array()},
            {"yields", state.yielded},
            {"cameras", state.camera_files}};
  for (const auto& [name, status] : state.processes) json["processes"].push_back(json_of(status));
  if (state.questions != nullptr)
    for (const OpenQuestion& question : state.questions->open()) json["questions"].push_back(json_of(question));
  return dump(json);
}

std::string state_text(const std::string& text) try {
  const Json json = Json::parse(text);
  const auto words = [](const Json& value) { return command::printable(value.get<std::string>()); };
  const double period = json.at("servo_period").get<double>();
  std::string lines = fmt::format("{}: {} under the clock '{}', tick {} ({:.3f} s){}\n", words(json.at("deployment")),
                                  words(json.at("task")), words(json.at("clock")), json.at("tick").get<Tick>(),
                                  static_cast<double>(json.at("tick").get<Tick>()) * period,
                                  json.at("emergency_stop").get<bool>() ? ", EMERGENCY STOP" : "");
  if (const double speed = json.at("speed").get<double>(); speed != 1)
    lines += fmt::format("{:<12} {:g} % of the programmed one\n", "speed", 100 * speed);
  const Json& commander = json.at("commander");
  lines += fmt::format("{:<12} {}\n", "command", commander.is_null() ? "free" : "held by " + words(commander));
  for (const Json& process : json.at("processes")) {
    lines += fmt::format("{:<12} {:<8} {:9.3f} s", words(process.at("name")), words(process.at("state")),
                         static_cast<double>(process.at("tick").get<Tick>()) * period);
    if (process.at("instruction").get<std::uint64_t>() > 0)
      lines += fmt::format("  {} {}, step {}", process.at("instruction").get<std::uint64_t>(),
                           words(process.at("activity")), process.at("step").get<std::uint64_t>());
    if (process.contains("error"))
      lines += "  " + words(process.at("error").at("text")) + ": " + words(process.at("error").at("detail"));
    lines += "\n";
  }
  for (const Json& robot : json.value("yields", Json::array()))
    lines += fmt::format("{:<12} follows trajectories of 'follow' and of ROS 2\n", words(robot));
  for (const Json& question : json.at("questions"))
    lines += fmt::format("{:<12} asks: {} ({})\n", words(question.at("from")), words(question.at("text")),
                         words(question.at("expected")));
  return lines;
} catch (const Json::exception& error) {
  throw std::runtime_error(std::string{"the run's answer is not a state: "} + error.what());
}

std::string run_line(const std::string& deployment, int pid, const std::string& text) try {
  const Json json = Json::parse(text);
  const double time = static_cast<double>(json.at("tick").get<Tick>()) * json.at("servo_period").get<double>();
  return fmt::format("{:<24} {:<8} {:>9.3f} s  clock {:<8}  process {}\n", command::printable(deployment),
                     json.at("task").get<std::string>(), time, json.at("clock").get<std::string>(), pid);
} catch (const Json::exception& error) {
  throw std::runtime_error(std::string{"the run's answer is not a state: "} + error.what());
}

std::string process_event(const links::ProcessStatus& status) { return event("process", json_of(status)); }

std::string question_event(const OpenQuestion& question) { return event("question", json_of(question)); }

std::string message_event(const std::string& text) { return event("message", Json{{"text", text}}); }

std::string event_text(const std::string& line) try {
  const Json json = Json::parse(line);
  const auto text = [&json](const char* name) { return json.at(name).get<std::string>(); };
  const std::string event = json.value("event", "");
  std::string shown;
  if (event == "message") shown = text("text");
  if (event == "process") {
    shown = fmt::format("{:<12} {:<8}", text("name"), text("state"));
    if (const auto number = json.at("instruction").get<std::uint64_t>(); number > 0)
      shown += fmt::format(" {} {}", number, text("activity"));
    if (json.contains("error"))
      shown += "  " + json.at("error").at("text").get<std::string>() + ": " +
               json.at("error").at("detail").get<std::string>();
  }
  if (event == "question") shown = text("from") + " asks: " + text("text") + " (" + text("expected") + ")";
  if (event == "command")
    shown = fmt::format("{} by {} at tick {}", text("command"), text("by"), json.at("tick").get<Tick>());
  if (event == "robot")
    shown =
        fmt::format("{:<12} tick {} joints{}", text("name"), json.at("tick").get<Tick>(), list_of(json.at("joints")));
  if (event == "reading")
    shown = fmt::format("{:<12} tick {}{}", text("name"), json.at("tick").get<Tick>(), list_of(json.at("values")));
  if (event == "world") shown = fmt::format("{:<12} tick {}", "world", json.at("tick").get<Tick>());
  if (event == "command_wanted") shown = text("by") + " asks for command, " + text("commander") + " holds it";
  if (event == "commander")
    shown = json.at("commander").is_null() ? "command is free" : text("commander") + " holds command";
  if (event == "yield")
    shown = text("robot") + (json.at("open").get<bool>() ? " follows trajectories" : " follows no trajectories");
  if (event == "end")
    shown = fmt::format("the run has ended with exit code {}{}", json.at("exit_code").get<int>(),
                        text("reason").empty() ? "" : ": " + text("reason"));
  return command::printable_lines(shown);
} catch (const Json::exception&) {
  return "";
}

std::string command_event(const config::Event& event, const std::string& by, TaskPhase phase) {
  Json json{
      {"event", "command"}, {"command", event.command}, {"by", by}, {"tick", event.tick}, {"task", name_of(phase)}};
  if (event.command == "speed") json["value"] = event.value;
  return dump(json);
}

std::string commander_event(const std::string& name) {
  return dump({{"event", "commander"}, {"commander", name.empty() ? Json(nullptr) : Json(name)}});
}

std::string command_wanted_event(const std::string& by, const std::string& holder) {
  return dump({{"event", "command_wanted"}, {"by", by}, {"commander", holder}});
}

std::string yield_event(const std::string& robot, bool open) {
  return dump({{"event", "yield"}, {"robot", robot}, {"open", open}});
}

std::string end_event(int exit_code, const std::string& reason) {
  return dump({{"event", "end"}, {"exit_code", exit_code}, {"reason", reason}});
}

}  // namespace mrroc::cli
