#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mrroc::config {

/// A mistake in a file or on the command line: the message reads "<file>:<line>: <key>: <what is wrong>, expected
/// <what>".
class ConfigurationError : public std::runtime_error {
 public:
  ConfigurationError(const std::filesystem::path& file, int line, const std::string& key, const std::string& problem,
                     const std::string& expected);

  /// As given; the key is "" where no key is wrong.
  const std::string& key() const noexcept { return parts_->key; }
  const std::string& problem() const noexcept { return parts_->problem; }
  const std::string& expected() const noexcept { return parts_->expected; }

 private:
  struct Parts {
    std::string key, problem, expected;
  };
  std::shared_ptr<const Parts> parts_;  // a copy of an error does not throw
};

/// Bounds of a number, both included.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};

/// Read-only view of one TOML table with its position in the file. Every getter throws ConfigurationError naming file,
/// line, full key (`robots.arm.type`), the value found and what was expected: missing key, wrong type, not finite, out
/// of range. `finish()` refuses unused keys and names the nearest known one. Copies share the record of used keys.
/// Configuration time only; any thread, one at a time.
class Table {
 public:
  /// Parses a TOML file; a syntax error or an unreadable file is a ConfigurationError.
  static Table load(const std::filesystem::path& file);
  /// The same for a text that was read before; `file` is its name in messages.
  static Table parse(const std::filesystem::path& file, const std::string& text);

  bool has(std::string_view key) const;
  std::string text(std::string_view key) const;
  std::optional<std::string> optional_text(std::string_view key) const;
  /// One of `choices`; the message lists them.
  std::string choice(std::string_view key, const std::vector<std::string>& choices) const;
  double number(std::string_view key, Range range = {}) const;
  double number_or(std::string_view key, double fallback, Range range = {}) const;
  /// A number, or TOML's `inf` or `-inf` for no limit.
  double limit(std::string_view key) const;
  std::int64_t integer(std::string_view key, std::int64_t min, std::int64_t max) const;
  std::int64_t integer_or(std::string_view key, std::int64_t fallback, std::int64_t min, std::int64_t max) const;
  bool boolean_or(std::string_view key, bool fallback) const;
  /// An array of texts of any length.
  std::vector<std::string> texts(std::string_view key) const;
  /// An array of numbers; `size` 0: any length.
  std::vector<double> numbers(std::string_view key, std::size_t size = 0, Range range = {}) const;
  std::optional<std::vector<double>> optional_numbers(std::string_view key, std::size_t size = 0,
                                                      Range range = {}) const;

  /// A sub-table; missing or of another type: error.
  Table table(std::string_view key) const;
  std::optional<Table> optional_table(std::string_view key) const;
  /// Array of tables `[[key]]`; empty when missing.
  std::vector<Table> tables(std::string_view key) const;
  /// Names of all sub-tables, in file order; a key that is not a table is an error.
  std::vector<std::string> table_names() const;
  /// Keys of this table in file order.
  std::vector<std::string> keys() const;

  /// Marks `keys` as used, then calls `finish()`. Called before the values are read, it reports a misspelt key before
  /// the consequences of it.
  void only(std::initializer_list<std::string_view> keys) const;

  /// Throws if a key of this table (not of its sub-tables) was never used.
  void finish() const;

  /// An error at `key` of this table (or at the table itself when empty), for the caller's own checks.
  [[noreturn]] void fail(std::string_view key, const std::string& problem, const std::string& expected) const;
  const std::filesystem::path& file() const;
  int line(std::string_view key = {}) const;

 private:
  struct Node;
  explicit Table(std::shared_ptr<const Node> node);
  std::shared_ptr<const Node> node_;
};

}  // namespace mrroc::config
