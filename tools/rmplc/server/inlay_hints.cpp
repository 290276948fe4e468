// What stands between the words of a text: of long times, hours, minutes and seconds.
// SPDX-License-Identifier: MIT
#include <string>
#include <string_view>

#include "automata/time/time.hpp"
#include "grammar/editor/tokens.hpp"
#include "runtime/executive/scenario/moment.hpp"
#include "tools/rmplc/server/features.hpp"
#include "tools/rmplc/server/positions.hpp"

namespace rmpl::tools {
namespace {

constexpr automata::Ticks long_time = automata::Ticks::of_seconds(60);

/// Where the range that was asked for begins and ends; all of the text without one.
std::pair<std::uint32_t, std::uint32_t> range_in(const grammar::SourceFile& source, const Json& params) {
  const auto range = params.find("range");
  if (range == params.end() || !range->is_object()) return {0, static_cast<std::uint32_t>(source.text().size())};
  return {offset_of(source, member(*range, "start")), offset_of(source, member(*range, "end"))};
}

}  // namespace

/// Behind a number with a unit of time that is a minute or longer, unless it is written in the largest unit it fills.
Json inlay_hints(Workspace& workspace, const Json& params) {
  const grammar::SourceFile& source = *workspace.documents().of(params).source;
  const auto [begin, end] = range_in(source, params);
  const std::string_view text = source.text();
  Json hints = Json::array();
  std::string_view number;
  for (const grammar::TextToken& token : grammar::tokens_of(text)) {
    if (token.begin >= end) break;
    if (token.kind == grammar::TokenKind::comment) continue;
    const std::string_view word = token.in(text);
    const std::string_view amount = std::exchange(number, token.kind == grammar::TokenKind::number ? word : "");
    if (amount.empty() || token.begin < begin) continue;
    const bool unit = word == "s" || word == "min" || word == "ms" || word == "us" || word == "ns";
    if (!unit) continue;
    const auto time = automata::parse_duration(std::string(amount) + " " + std::string(word));
    if (!time || time->is_infinite() || *time < long_time) continue;
    if (word == "min" && *time < automata::Ticks::of_seconds(3600)) continue;
    hints.push_back({{"position", position_of(source, token.end)},
                     {"label", "(" + runtime::hours_minutes_seconds(*time) + ")"},
                     {"paddingLeft", true}});
  }
  return hints;
}

}  // namespace rmpl::tools
