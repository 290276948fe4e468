// The registry of codes: look-up over its parts.
// SPDX-License-Identifier: MIT
#include "grammar/source/codes.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

#include "base/check.hpp"
#include "grammar/source/code_tables.hpp"
#include "grammar/source/monitor_codes.hpp"

namespace rmpl::grammar {
namespace {

const CodeInfo* look_up(Code code) {
  for (const auto table :
       {text_codes(), name_codes(), plant_codes(), chance_codes(), program_codes(), model_codes(), scenario_codes(),
        monitor_codes(), lint_codes(), lint_flight_codes(), lint_plant_codes(), lint_transition_codes(),
        lint_sensing_codes(), document_codes(), property_codes(), netlist_codes()}) {
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const CodeInfo& info) { return info.code == code; });
    if (found != table.end()) return &*found;
  }
  return nullptr;
}

}  // namespace

std::string to_string(Code code) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "RMPL%04u", static_cast<unsigned>(code));
  return text.data();
}

std::optional<Code> find_code(std::string_view text) {
  constexpr std::string_view prefix = "RMPL";
  const auto is_prefix = [&](std::string_view start) {
    return std::equal(start.begin(), start.end(), prefix.begin(), prefix.end(),
                      [](char a, char b) { return a == b || a == b + ('a' - 'A'); });
  };
  if (is_prefix(text.substr(0, prefix.size()))) text.remove_prefix(prefix.size());
  std::uint16_t number = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
  const auto code = static_cast<Code>(number);
  if (look_up(code) == nullptr) return std::nullopt;
  return code;
}

const CodeInfo& info(Code code) {
  const CodeInfo* found = look_up(code);
  CHECK(found != nullptr && "every code has an entry in the registry");
  return *found;
}

std::vector<CodeInfo> all_codes() {
  std::vector<CodeInfo> all;
  for (const auto table :
       {text_codes(), name_codes(), plant_codes(), chance_codes(), program_codes(), model_codes(), scenario_codes(),
        monitor_codes(), lint_codes(), lint_flight_codes(), lint_plant_codes(), lint_transition_codes(),
        lint_sensing_codes(), document_codes(), property_codes(), netlist_codes()})
    all.insert(all.end(), table.begin(), table.end());
  std::sort(all.begin(), all.end(), [](const CodeInfo& a, const CodeInfo& b) { return a.code < b.code; });
  return all;
}

}  // namespace rmpl::grammar
