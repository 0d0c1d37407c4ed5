#include "cli/operator/verb_request.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "config/text/message_text.hpp"

namespace mrroc::cli {

namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::size_t kLongestValue = 256, kLongestPath = 4096;  // of an argument, bytes
constexpr int kDeepest = 8;                                      // nesting of a request

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// Removes and returns the first word of `text`.
std::string_view take_word(std::string_view& text) {
  const std::string_view word = text.substr(0, std::min(text.find_first_of(kBlanks), text.size()));
  text = trimmed(text.substr(word.size()));
  return word;
}

std::string shown_word(std::string_view text) { return config::in_quotes(std::string{text.substr(0, 64)}); }

VerbReply refuse_verb(std::string_view name) {
  const std::string nearest = nearest_verb(name);
  std::vector<std::string> names;
  for (const OperatorVerb& verb : operator_verbs()) names.emplace_back(verb.name);
  if (nearest.empty())
    return refuse(Refusal::unknown_verb, "unknown verb " + shown_word(name), config::alternatives(names));
  return refuse(Refusal::unknown_verb, "unknown verb " + shown_word(name) + ", did you mean '" + nearest + "'?");
}

std::string members_of(const OperatorVerb& verb) {
  std::vector<std::string> names;
  for (const VerbArgument& argument : verb.arguments) names.emplace_back(argument.name);
  return names.empty() ? "no arguments" : config::alternatives(names);
}

/// Checks names, presence and values of the arguments.
bool check_arguments(const VerbRequest& request, VerbReply& refusal) {
  for (const auto& [name, value] : request.arguments) {
    const auto named = [&name = name](const VerbArgument& argument) { return argument.name == name; };
    const auto known = std::find_if(request.verb->arguments.begin(), request.verb->arguments.end(), named);
    if (known == request.verb->arguments.end()) {
      refusal =
          refuse(Refusal::invalid_argument, std::string{request.verb->name} + ": unknown argument " + shown_word(name),
                 members_of(*request.verb));
      return false;
    }
    const std::size_t longest = known->file ? kLongestPath : kLongestValue;
    if (value.empty() || value.size() > longest) {
      refusal =
          refuse(Refusal::invalid_argument,
                 std::string{request.verb->name} + ": " + name + " has " + std::to_string(value.size()) + " bytes",
                 "1 to " + std::to_string(longest));
      return false;
    }
  }
  for (const VerbArgument& argument : request.verb->arguments) {
    if (argument.file && request.argument(argument.name).find('\0') != std::string_view::npos) {
      refusal = refuse(Refusal::invalid_argument,
                       std::string{request.verb->name} + ": " + std::string{argument.name} + " contains a zero byte",
                       "a path");
      return false;
    }
    if (!argument.required || request.arguments.contains(argument.name)) continue;
    refusal = refuse(Refusal::invalid_argument,
                     std::string{request.verb->name} + ": " + std::string{argument.name} + " is missing",
                     usage_of(*request.verb));
    return false;
  }
  return true;
}

/// Takes a word "name=value" that is one of the optional arguments.
bool take_optional(std::string_view& text, VerbRequest& request) {
  for (const VerbArgument& argument : request.verb->arguments) {
    if (argument.required || !text.starts_with(argument.name)) continue;
    if (!text.substr(argument.name.size()).starts_with('=')) continue;
    request.arguments.emplace(argument.name, take_word(text).substr(argument.name.size() + 1));
    return true;
  }
  return false;
}

/// The same of the last word.
bool take_last_optional(std::string_view& text, VerbRequest& request) {
  const std::size_t blank = text.find_last_of(kBlanks);
  if (blank == std::string_view::npos) return false;
  std::string_view last = text.substr(blank + 1);
  if (!take_optional(last, request)) return false;
  text = trimmed(text.substr(0, blank));
  return true;
}

/// A member of the request as the text that would be typed.
std::optional<std::string> text_of(const nlohmann::json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return std::string{value.get<bool>() ? "yes" : "no"};
  if (value.is_number()) return value.dump();
  return std::nullopt;
}

}  // namespace

std::string_view VerbRequest::argument(std::string_view name) const {
  const auto found = arguments.find(name);
  return found == arguments.end() ? std::string_view{} : std::string_view{found->second};
}

std::optional<VerbRequest> parse_typed(std::string_view line, VerbReply& refusal) {
  std::string_view rest = trimmed(line);
  const std::string_view name = take_word(rest);
  VerbRequest request;
  request.verb = find_verb(name);
  if (request.verb == nullptr) {
    refusal = refuse_verb(name);
    return std::nullopt;
  }
  while (take_optional(rest, request) || take_last_optional(rest, request)) {
  }
  const VerbArgument* last = nullptr;
  for (const VerbArgument& argument : request.verb->arguments)
    if (argument.required) last = &argument;
  for (const VerbArgument& argument : request.verb->arguments) {
    if (!argument.required || rest.empty()) continue;
    request.arguments.emplace(argument.name, &argument == last ? std::exchange(rest, {}) : take_word(rest));
  }
  if (!rest.empty()) {
    refusal = refuse(Refusal::invalid_argument, std::string{name} + ": " + shown_word(rest) + " is too much",
                     usage_of(*request.verb));
    return std::nullopt;
  }
  if (!check_arguments(request, refusal)) return std::nullopt;
  return request;
}

std::optional<VerbRequest> parse_json(std::string_view line, VerbReply& refusal) {
  bool deep = false;
  const auto shallow = [&deep](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    deep = deep || depth > kDeepest;
    return true;
  };
  const nlohmann::json json = nlohmann::json::parse(line, shallow, false);
  const std::string expected = R"(a JSON object such as {"verb": "status"})";
  if (json.is_discarded() || deep || !json.is_object()) {
    refusal = refuse(Refusal::malformed, "the line is not a request", expected);
    return std::nullopt;
  }
  VerbRequest request;
  if (const auto id = json.find("id"); id != json.end()) {
    constexpr auto kLargest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    if (!id->is_number_integer() || (id->is_number_unsigned() && id->get<std::uint64_t>() > kLargest)) {
      refusal = refuse(Refusal::malformed, "id is not an integer of 64 bits", expected);
      return std::nullopt;
    }
    request.id = id->get<std::int64_t>();
  }
  const auto understood = [&]() -> bool {
    const auto verb = json.find("verb");
    if (verb == json.end() || !verb->is_string()) {
      refusal = refuse(Refusal::malformed, verb == json.end() ? "verb is missing" : "verb is not a text", expected);
      return false;
    }
    const std::string name = verb->get<std::string>();
    request.verb = find_verb(name);
    if (request.verb == nullptr) {
      refusal = refuse_verb(name);
      return false;
    }
    for (const auto& [key, value] : json.items()) {
      if (key == "verb" || key == "id") continue;
      const std::optional<std::string> text = text_of(value);
      if (!text) {
        refusal = refuse(Refusal::malformed, key.substr(0, 64) + " is neither a text nor a number", expected);
        return false;
      }
      request.arguments.emplace(key, *text);
    }
    return check_arguments(request, refusal);
  };
  if (understood()) return request;
  refusal.id = request.id;
  return std::nullopt;
}

}  // namespace mrroc::cli
