// Writes one line of JSON into a buffer that is kept: no tree is built, numbers read back as they were.
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "automata/logic/variables.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/time/time.hpp"
#include "base/function_ref.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::runtime {

/// Per component, per mode: whether its clock counts.
using ClockTable = std::vector<std::vector<bool>>;

/// The clocks that make a difference (automata/clock_use.hpp): the estimators forget the others.
ClockTable live_clocks(const automata::Plant& plant);

/// A JSON text under construction. Commas come by themselves; the caller opens, closes and names in a legal order.
class JsonLine {
 public:
  void clear();
  [[nodiscard]] const std::string& text() const { return text_; }

  JsonLine& open(char bracket);   ///< `{` or `[`
  JsonLine& close(char bracket);  ///< `}` or `]`
  JsonLine& key(std::string_view name);
  JsonLine& string(std::string_view value);
  JsonLine& number(double value);  ///< finite; the shortest decimal that reads back the same
  template <std::integral Number>
  JsonLine& number(Number value) {
    separate();
    text_ += std::to_string(value);
    return *this;
  }
  JsonLine& seconds(automata::Ticks value);   ///< finite
  JsonLine& digits(std::string_view number);  ///< a number that is written already
  JsonLine& raw(std::string_view text);       ///< as it stands, with the commas that it needs
  JsonLine& boolean(bool value);
  JsonLine& null();

  /// `{"variable":"value",…}` in the order given.
  JsonLine& assignments(std::span<const automata::Assignment> assignments, const automata::Variables& variables);
  /// `{"component":"mode",…}` in declaration order.
  JsonLine& modes(const automata::Modes& modes, const automata::Plant& plant);
  /// `[{"probability":…,"modes":{…},"clocks":{…}},…]`, clocks in seconds since they started; with `clocks`, only
  /// those that the table has for their component and mode. With `rank`, that of the best, each has a `rank` in place
  /// of the probability. `go_on` is called for each, and may throw.
  JsonLine& belief(
      const Belief& belief, const automata::Plant& plant, automata::Ticks now, const ClockTable* clocks = nullptr,
      const std::uint64_t* rank = nullptr, base::FunctionRef<void()> go_on = [] {});

 private:
  void separate();
  void quote(std::string_view value);

  std::string text_;
  bool first_ = true;  ///< the next element needs no comma before it
};

}  // namespace rmpl::runtime
