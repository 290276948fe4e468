// JSON by appending to a string.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/json_line.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include "automata/clock_use.hpp"

#include "base/check.hpp"
#include "runtime/reasoning/estimate/rank.hpp"

namespace rmpl::runtime {
namespace {

/// Whether JSON has it escaped.
bool is_special(char c) { return c == '"' || c == '\\' || static_cast<unsigned char>(c) < 0x20; }

}  // namespace

ClockTable live_clocks(const automata::Plant& plant) {
  ClockTable table;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    auto& live = table.emplace_back();
    for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m) {
      live.push_back(automata::needs_clock(plant.components[c], automata::ModeId(m)));
    }
  }
  return table;
}

void JsonLine::clear() {
  text_.clear();
  first_ = true;
}

void JsonLine::separate() {
  if (!first_) text_ += ',';
  first_ = false;
}

void JsonLine::quote(std::string_view value) {
  static constexpr std::string_view digits = "0123456789abcdef";
  text_ += '"';
  // Nearly every name and value is written as it is.
  const auto special = std::find_if(value.begin(), value.end(), [](char c) { return is_special(c); });
  text_.append(value.data(), static_cast<std::size_t>(special - value.begin()));
  value.remove_prefix(static_cast<std::size_t>(special - value.begin()));
  for (const char c : value) {
    const auto byte = static_cast<unsigned char>(c);
    if (!is_special(c)) {
      text_ += c;
    } else if (byte >= 0x20) {
      text_ += '\\';
      text_ += c;
    } else {
      text_ += "\\u00";
      text_ += digits[byte >> 4U];
      text_ += digits[byte & 15U];
    }
  }
  text_ += '"';
}

JsonLine& JsonLine::open(char bracket) {
  separate();
  text_ += bracket;
  first_ = true;
  return *this;
}

JsonLine& JsonLine::close(char bracket) {
  text_ += bracket;
  first_ = false;
  return *this;
}

JsonLine& JsonLine::key(std::string_view name) {
  separate();
  quote(name);
  text_ += ':';
  first_ = true;
  return *this;
}

JsonLine& JsonLine::string(std::string_view value) {
  separate();
  quote(value);
  return *this;
}

JsonLine& JsonLine::number(double value) {
  CHECK(std::isfinite(value) && "JSON has finite numbers only");
  separate();
  std::array<char, 32> digits{};
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text_.append(digits.data(), result.ptr);
  return *this;
}

JsonLine& JsonLine::seconds(automata::Ticks value) {
  CHECK(!value.is_infinite() && "a time that is written has come");
  separate();
  text_ += automata::format_seconds(value);
  return *this;
}

JsonLine& JsonLine::digits(std::string_view number) {
  separate();
  text_ += number;
  return *this;
}

JsonLine& JsonLine::raw(std::string_view text) {
  text_ += text;
  first_ = false;
  return *this;
}

JsonLine& JsonLine::boolean(bool value) {
  separate();
  text_ += value ? "true" : "false";
  return *this;
}

JsonLine& JsonLine::null() {
  separate();
  text_ += "null";
  return *this;
}

JsonLine& JsonLine::assignments(std::span<const automata::Assignment> assignments,
                                const automata::Variables& variables) {
  open('{');
  for (const automata::Assignment& a : assignments) key(variables.name(a.variable)).string(variables.value(a));
  return close('}');
}

JsonLine& JsonLine::modes(const automata::Modes& modes, const automata::Plant& plant) {
  open('{');
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const automata::Component& component = plant.components[i];
    key(component.name).string(component.modes[modes[i].index()].name);
  }
  return close('}');
}

JsonLine& JsonLine::belief(const Belief& belief, const automata::Plant& plant, automata::Ticks now,
                           const ClockTable* clocks, const std::uint64_t* rank, base::FunctionRef<void()> go_on) {
  open('[');
  for (const BeliefEntry& entry : belief) {
    go_on();
    open('{');
    if (rank != nullptr) {
      key("rank").number(*rank + rank_of(entry.probability));
    } else {
      key("probability").number(entry.probability);
    }
    key("modes").modes(entry.state.modes, plant).key("clocks").open('{');
    for (std::size_t i = 0; i < entry.state.clock_starts.size(); ++i) {
      if (clocks != nullptr && !(*clocks)[i][entry.state.modes[i].index()]) continue;
      key(plant.components[i].name).seconds(now - entry.state.clock_starts[i]);
    }
    close('}').close('}');
  }
  return close(']');
}

}  // namespace rmpl::runtime
