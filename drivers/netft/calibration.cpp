#include "drivers/netft/calibration.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "core/number_text.hpp"

namespace mrroc::netft {

namespace {

using config::in_quotes;

constexpr double kPoundForce = 4.4482216152605;  // N
constexpr double kKilogramForce = 9.80665;       // N
constexpr double kInch = 0.0254;                 // m
constexpr double kFoot = 0.3048;                 // m

struct Unit {
  std::string_view name;  ///< without hyphens
  double si;
  int code;  ///< of cfgfu or cfgtu; 0: none
  std::string_view shown;
};

constexpr std::array<Unit, 6> kForces{{{"lbf", kPoundForce, 1, "lbf"},
                                       {"N", 1, 2, "N"},
                                       {"klbf", 1000 * kPoundForce, 3, "klbf"},
                                       {"kN", 1000, 4, "kN"},
                                       {"kgf", kKilogramForce, 5, "kgf"},
                                       {"gf", kKilogramForce / 1000, 0, "gf"}}};

constexpr std::array<Unit, 7> kTorques{{{"lbfin", kPoundForce* kInch, 1, "lbf-in"},
                                        {"lbfft", kPoundForce* kFoot, 2, "lbf-ft"},
                                        {"Nm", 1, 3, "N-m"},
                                        {"Nmm", 0.001, 4, "N-mm"},
                                        {"kgfcm", kKilogramForce / 100, 5, "kgf-cm"},
                                        {"kgcm", kKilogramForce / 100, 0, "kg-cm"},
                                        {"kNm", 1000, 6, "kN-m"}}};

template <std::size_t Size>
std::optional<double> by_name(const std::array<Unit, Size>& units, std::string_view text) {
  std::string name(text);
  std::erase_if(name, [](char each) { return each == '-' || each == ' '; });
  for (const Unit& unit : units) {
    if (unit.name == name) return unit.si;
  }
  return {};
}

template <std::size_t Size>
std::string names_of(const std::array<Unit, Size>& units) {
  std::vector<std::string> names;
  names.reserve(Size);
  for (const Unit& unit : units) names.emplace_back(unit.shown);
  return config::alternatives(names);
}

/// The elements of the page, wherever they are in it.
class Page {
 public:
  Page(const std::string& xml, std::string address) : address_(std::move(address)) {
    if (document_.Parse(xml.data(), xml.size()) == tinyxml2::XML_SUCCESS && document_.RootElement() != nullptr) return;
    throw config::ConfigurationError(address_, document_.ErrorLineNum(), "", "not an XML page",
                                     "the configuration page of a Net F/T");
  }

  /// Text of the element `name`; nothing: there is no such element.
  std::optional<std::string> text(const char* name) const {
    const tinyxml2::XMLElement* const found = find(name);
    if (found == nullptr) return {};
    std::string_view value = found->GetText() == nullptr ? "" : found->GetText();
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t first = value.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return "";
    value = value.substr(first, value.find_last_not_of(kBlanks) - first + 1);
    return std::string(value);
  }

  double positive(const char* name) const {
    const std::string expected = "a number above 0";
    const auto value = text(name);
    if (!value) fail(name, "missing", expected);
    const auto number = core::to_finite(*value);
    if (!number || !(*number > 0)) fail(name, in_quotes(*value), expected);
    return *number;
  }

  /// A unit by its name in `name` or, where that is missing, by its number in `code`.
  template <std::size_t Size>
  double unit(const std::array<Unit, Size>& units, const char* name, const char* code) const {
    if (const auto value = text(name)) {
      const auto si = by_name(units, *value);
      if (!si) fail(name, in_quotes(*value), names_of(units));
      return *si;
    }
    const auto number = text(code);
    if (!number) fail(name, "missing", names_of(units));
    const auto wanted = core::to_whole<int>(*number);
    for (const Unit& each : units) {
      if (each.code != 0 && wanted == each.code) return each.si;
    }
    fail(code, in_quotes(*number), "the number of a unit: " + names_of(units));
  }

  [[noreturn]] void fail(const char* name, const std::string& problem, const std::string& expected) const {
    const tinyxml2::XMLElement* const found = find(name);
    throw config::ConfigurationError(address_, found == nullptr ? 0 : found->GetLineNum(), name, problem, expected);
  }

 private:
  /// The next element in the order of the text.
  static const tinyxml2::XMLElement* after(const tinyxml2::XMLElement* element) {
    if (const auto* const child = element->FirstChildElement()) return child;
    while (element != nullptr) {
      if (const auto* const next = element->NextSiblingElement()) return next;
      const tinyxml2::XMLNode* const parent = element->Parent();
      element = parent == nullptr ? nullptr : parent->ToElement();
    }
    return nullptr;
  }

  const tinyxml2::XMLElement* find(const char* name) const {
    const tinyxml2::XMLElement* found = nullptr;
    for (const auto* each = document_.RootElement(); each != nullptr; each = after(each)) {
      if (std::strcmp(each->Name(), name) != 0) continue;
      if (found != nullptr) {
        throw config::ConfigurationError(address_, each->GetLineNum(), name,
                                         "also in line " + std::to_string(found->GetLineNum()), "one element");
      }
      found = each;
    }
    return found;
  }

  std::string address_;
  tinyxml2::XMLDocument document_;
};

double factor(const Page& page, const char* counts, double unit) {
  const double made = unit / page.positive(counts);
  if (!std::isnormal(made)) page.fail(counts, in_quotes(page.text(counts).value_or("")), "counts of a Net F/T");
  return made;
}

std::uint32_t status_of(const Page& page) {
  const auto text = page.text("runstat");
  if (!text) return 0;
  const auto value = core::to_literal(*text);
  if (!value || *value > 0xffff'ffff) page.fail("runstat", in_quotes(*text), "a status of 32 bits, as 0x00000000");
  return static_cast<std::uint32_t>(*value);
}

}  // namespace

std::optional<double> newtons(std::string_view unit) { return by_name(kForces, unit); }

std::optional<double> newton_metres(std::string_view unit) { return by_name(kTorques, unit); }

SensorConfiguration read_configuration(const std::string& xml, const std::string& address) {
  const Page page(xml, address);
  SensorConfiguration read;
  read.calibration = {factor(page, "cfgcpf", page.unit(kForces, "scfgfu", "cfgfu")),
                      factor(page, "cfgcpt", page.unit(kTorques, "scfgtu", "cfgtu"))};
  read.product = page.text("prodname").value_or("");
  if (page.text("comrdtrate")) read.rate = page.positive("comrdtrate");
  const std::string enabled = page.text("comrdte").value_or("Enabled");
  read.rdt_enabled = enabled == "Enabled" || enabled == "1";
  read.status = status_of(page);
  return read;
}

}  // namespace mrroc::netft
