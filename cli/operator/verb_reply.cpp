#include "cli/operator/verb_reply.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace mrroc::cli {

namespace {

constexpr Refusal kRefusals[]{Refusal::malformed,          Refusal::unknown_verb,   Refusal::invalid_argument,
                              Refusal::not_allowed,        Refusal::not_commander,  Refusal::ended,
                              Refusal::invalid_trajectory, Refusal::path_tolerance, Refusal::goal_tolerance,
                              Refusal::cancelled,          Refusal::taken_back};

}  // namespace

const char* name_of(Refusal refusal) noexcept {
  switch (refusal) {
    case Refusal::none:
      return "none";
    case Refusal::malformed:
      return "malformed";
    case Refusal::unknown_verb:
      return "unknown_verb";
    case Refusal::invalid_argument:
      return "invalid_argument";
    case Refusal::not_allowed:
      return "not_allowed";
    case Refusal::not_commander:
      return "not_commander";
    case Refusal::ended:
      return "ended";
    case Refusal::invalid_trajectory:
      return "invalid_trajectory";
    case Refusal::path_tolerance:
      return "path_tolerance";
    case Refusal::goal_tolerance:
      return "goal_tolerance";
    case Refusal::cancelled:
      return "cancelled";
    case Refusal::taken_back:
      return "taken_back";
  }
  return "?";
}

VerbReply done(std::string text) {
  VerbReply reply;
  reply.text = std::move(text);
  return reply;
}

VerbReply refuse(Refusal refusal, std::string text, std::string expected) {
  VerbReply reply;
  reply.refusal = refusal;
  reply.text = std::move(text);
  reply.expected = std::move(expected);
  return reply;
}

VerbReply not_now(std::string text, std::string expected) {
  return refuse(Refusal::not_allowed, std::move(text), std::move(expected));
}

std::string to_json(const VerbReply& reply) {
  nlohmann::ordered_json json;
  if (reply.id) json["id"] = *reply.id;
  json["ok"] = reply.ok();
  if (!reply.ok()) json["reason"] = name_of(reply.refusal);
  if (reply.tick) json["tick"] = *reply.tick;
  json["text"] = reply.text;
  if (!reply.expected.empty()) json["expected"] = reply.expected;
  if (!reply.data.empty()) json["data"] = nlohmann::ordered_json::parse(reply.data);
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::optional<VerbReply> parse_reply(const std::string& json) {
  const auto read = nlohmann::ordered_json::parse(json, nullptr, false);
  if (!read.is_object() || !read.contains("ok") || !read["ok"].is_boolean()) return std::nullopt;
  const auto text = [&read](const char* name) {
    return read.contains(name) && read[name].is_string() ? read[name].get<std::string>() : std::string{};
  };
  VerbReply reply;
  if (!read["ok"].get<bool>()) {
    reply.refusal = Refusal::malformed;
    for (const Refusal refusal : kRefusals)
      if (text("reason") == name_of(refusal)) reply.refusal = refusal;
  }
  reply.text = text("text");
  reply.expected = text("expected");
  if (read.contains("tick") && read["tick"].is_number_integer()) reply.tick = read["tick"].get<Tick>();
  if (read.contains("id") && read["id"].is_number_integer()) reply.id = read["id"].get<std::int64_t>();
  if (read.contains("data")) reply.data = read["data"].dump();
  return reply;
}

std::string to_text(const VerbReply& reply) {
  return reply.expected.empty() ? reply.text : reply.text + ", expected " + reply.expected;
}

}  // namespace mrroc::cli
