#include "cli/trace/condition_value.hpp"

#include <optional>
#include <string_view>

namespace mrroc::cli::trace {

namespace {

enum class Link { both, either };

PossibleValues linked(Link link, PossibleValues a, PossibleValues b) {
  PossibleValues result{false, false};
  if (link == Link::both) {
    result.may_be_true = a.may_be_true && b.may_be_true;
    result.may_be_false = a.may_be_false || b.may_be_false;
  } else {
    result.may_be_true = a.may_be_true || b.may_be_true;
    result.may_be_false = a.may_be_false && b.may_be_false;
  }
  return result;
}

/// A sequence of parts with operators between them, for every placement of the brackets: computes the values of every
/// span from those of the shorter ones.
PossibleValues bracketed(const std::vector<PossibleValues>& row, const std::vector<Link>& links) {
  const std::size_t n = row.size();
  std::vector<std::vector<PossibleValues>> stretch(n, std::vector<PossibleValues>(n, {false, false}));
  for (std::size_t length = 1; length <= n; ++length) {
    for (std::size_t first = 0; first + length <= n; ++first) {
      PossibleValues& values = stretch[first][first + length - 1];
      if (length == 1) values = row[first];
      for (std::size_t middle = first; middle + 1 < first + length; ++middle) {
        const PossibleValues one =
            linked(links[middle], stretch[first][middle], stretch[middle + 1][first + length - 1]);
        values.may_be_true = values.may_be_true || one.may_be_true;
        values.may_be_false = values.may_be_false || one.may_be_false;
      }
    }
  }
  return stretch[0][n - 1];
}

/// Reads a composed name from left to right; its parts are in order.
class NameReader {
 public:
  NameReader(std::string_view name, const std::vector<ConditionEntry>& parts) : rest_(name), parts_(parts) {}

  std::optional<PossibleValues> whole() {
    const std::optional<PossibleValues> value = row();
    const bool all = rest_.empty() && next_ == parts_.size();
    return all ? value : std::nullopt;
  }

 private:
  bool take(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }

  std::optional<PossibleValues> row() {
    std::vector<PossibleValues> values;
    std::vector<Link> links;
    for (;;) {
      const std::optional<PossibleValues> value = part();
      if (!value) return std::nullopt;
      values.push_back(*value);
      if (take(" and "))
        links.push_back(Link::both);
      else if (take(" or "))
        links.push_back(Link::either);
      else
        return bracketed(values, links);
    }
  }

  /// Whether the next part's name follows, and not a longer name with the same beginning.
  bool take_part_name() {
    if (next_ == parts_.size() || !rest_.starts_with(parts_[next_].name)) return false;
    const std::string_view behind = rest_.substr(parts_[next_].name.size());
    if (!behind.empty() && !behind.starts_with(" and ") && !behind.starts_with(" or ") && !behind.starts_with(")"))
      return false;
    rest_ = behind;
    return true;
  }

  std::optional<PossibleValues> part() {
    if (take_part_name()) {
      const bool value = parts_[next_++].value;
      return PossibleValues{!value, value};
    }
    if (!take("not (")) return std::nullopt;
    const std::optional<PossibleValues> inner = row();
    if (!inner || !take(")")) return std::nullopt;
    return PossibleValues{inner->may_be_true, inner->may_be_false};
  }

  std::string_view rest_;
  const std::vector<ConditionEntry>& parts_;
  std::size_t next_ = 0;
};

}  // namespace

PossibleValues value_of_condition(const std::string& name, const std::vector<ConditionEntry>& parts) {
  return NameReader(name, parts).whole().value_or(PossibleValues{});
}

std::string text_of_values(const std::vector<ConditionEntry>& parts) {
  std::string text;
  for (const ConditionEntry& part : parts)
    text.append(text.empty() ? "" : " ").append("\"").append(part.name).append(part.value ? "\":1" : "\":0");
  return text;
}

}  // namespace mrroc::cli::trace
