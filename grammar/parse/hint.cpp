// Hints: a table of habits first, then the nearest keyword.
// SPDX-License-Identifier: MIT
#include "grammar/parse/hint.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "base/nearest.hpp"
#include "grammar/parse/hint_words.hpp"
#include "grammar/parse/scan.hpp"

namespace rmpl::grammar {
namespace {

/// The words between backquotes: the keywords that would have been right.
std::vector<std::string> keywords_in(std::string_view expected) {
  std::vector<std::string> keywords;
  for (std::size_t open = expected.find('`'); open != std::string_view::npos;) {
    const std::size_t close = expected.find('`', open + 1);
    if (close == std::string_view::npos) break;
    std::string word(expected.substr(open + 1, close - open - 1));
    if (identifier_at(word.data(), word.data() + word.size()) == word) keywords.push_back(std::move(word));
    open = expected.find('`', close + 1);
  }
  return keywords;
}

bool is_word(std::string_view text) { return !identifier_at(text.data(), text.data() + text.size()).empty(); }

std::string_view without_blank_before(std::string_view text) {
  const char* end = text.data() + text.size();
  const char* begin = skip_blank(text.data(), end);
  return {begin, static_cast<std::size_t>(end - begin)};
}

constexpr std::string_view no_clock =
    "a component's clock counts from when its mode was entered, and bounds transitions: `a -> b after 5 s`, `in [2 s, "
    "5 s]`";

/// Words of other languages; `meant` counts where it is expected.
constexpr std::array<Spelling, 14> words{{{"then", "thennext"},
                                          {"on", "when"},
                                          {"otherwise", "elsenext"},
                                          {"do", "donext"},
                                          {"do", "thennext"},
                                          {"donext", "thennext"},
                                          {"thennext", "donext"},
                                          {"then", "donext"},
                                          {"if", "when"},
                                          {"in", "within"},
                                          {"until", "watching"},
                                          {"while", "maintaining"},
                                          {"during", "for"},
                                          {"default", "initial"}}};

/// Signs that other languages write otherwise.
std::optional<Hint> sign_hint(const Unexpected& place) {
  if (place.found == "#") return say("a comment is written `// …` or `/* … */`");
  const auto after = [&](char c) { return place.before.ends_with(c); };
  if (after('=') && (place.found == "=" || place.found == ">")) {
    return say(place.found == "=" ? "equality is written with one `=`" : "an arrow is written `->`");
  }
  if (place.found == "=" && place.behind.starts_with(">")) return say("an arrow is written `->`");
  if (place.found == ":" && place.behind.starts_with("=")) return say("equality is written `=`");
  if (after('&') && place.found == "&") return say("`and` is written with one `&`");
  if (after('|') && place.found == "|") return say("`or` is written with one `|`");
  if (after('<') && place.found == ">") return say("`different` is written `!=`");
  if (place.found == "=" && place.expected.find("`default`") != std::string_view::npos)
    return did_you_mean("default", place.found);
  if (place.found == "%") return say("a probability is a number from 0 to 1");
  if (place.found == "*" && without_blank_before(place.behind).starts_with("->")) {
    Hint all = did_you_mean("any", place.found);
    all.suggestion += " `any nominal` leaves out the faults";
    return all;
  }
  if (place.expected == "`::`" || (place.expected == "`(`" && place.found == "::")) {
    return say("a definition is written `Name() :: { … }`");
  }
  return std::nullopt;
}

/// Whether the text is most likely a model program, which has values and no clocks.
bool of_model(const Unexpected& place) {
  const auto has = [&](std::string_view word) {
    return place.before.find(word) != std::string_view::npos || place.behind.find(word) != std::string_view::npos;
  };
  return has("model ") || has("variable ");
}

/// What stands in the place of a value, a string or a bound.
std::optional<Hint> value_hint(const Unexpected& place) {
  const bool number = std::isdigit(static_cast<unsigned char>(place.found.front())) != 0;
  const std::string_view before = without_blank_behind(place.before);
  const bool clock = place.clocks && before.ends_with('=') && !before.ends_with("!=") && !of_model(place);
  if (place.expected == "a value" && number && !clock) {
    return say("a value is a name, which begins with a letter: `zero`, `v" + std::string(place.found) + "`");
  }
  if (place.expected == "a value" && place.found == "0") return say("a clock is started by a step of its own: `t = 0`");
  if (place.expected == "an argument" && number) {
    return say("an argument is a name or a constraint: there are no numbers to count with");
  }
  if (place.expected == "a value" && number) return say("a clock is compared with <, <=, > or >=");
  if (place.expected == "a value" && place.found.front() == '"') return say("a value is written without quotes");
  if (place.expected == "a duration" && is_word(place.found)) {
    const bool compared = before.ends_with('<') || before.ends_with('>') || before.ends_with('=');
    if (compared && !place.clocks) return say("values are compared with `=`, `!=` and `in` only");
    if (compared) return say("only clocks are compared with <, <=, > and >=");
  }
  if (place.expected.starts_with("a string") && is_word(place.found)) {
    return Hint{"write it between quotes: \"" + std::string(place.found) + "\"", place.found,
                '"' + std::string(place.found) + '"'};
  }
  return std::nullopt;
}

Hint reserved(std::string_view word) {
  return say("`" + std::string(word) + "` is a reserved word and cannot be a name");
}

/// A reserved word where the signs behind it show that a name was meant.
std::optional<Hint> reserved_hint(const Unexpected& place) {
  if (!is_reserved(place.found) || place.found == "true" || place.found == "false") return std::nullopt;
  const std::string_view next = without_blank_before(place.behind);
  if (next.empty()) return std::nullopt;
  const std::string_view sign = token_at(next.data(), next.data() + next.size());
  const bool name = sign == ":" || sign == "=" || sign == "!=" || sign == "->" || sign == ";" || sign == ",";
  return name ? std::optional(reserved(place.found)) : std::nullopt;
}

/// The first word of the statement that the place is in.
std::string_view first_word(std::string_view before) {
  const std::size_t end = before.find_last_of(";{},\n");
  const std::string_view statement = end == std::string_view::npos ? before : before.substr(end + 1);
  const char* behind = statement.data() + statement.size();
  return identifier_at(skip_blank(statement.data(), behind), behind);
}

/// Statements of other languages, told by their first word.
std::optional<Hint> statement_hint(const Unexpected& place) {
  const std::string_view first = first_word(place.before);
  if (first.empty()) return std::nullopt;
  const bool steps = place.expected.starts_with("`=`, `!=`") || place.expected.starts_with("`;`, `,`");
  const bool top = place.expected == "`(`" && is_word(place.found);
  constexpr std::array<std::string_view, 8> definitions{"procedure", "proc",      "def",    "function",
                                                        "program",   "algorithm", "method", "void"};
  if (top && std::find(definitions.begin(), definitions.end(), first) != definitions.end()) {
    return say("a definition is written `Name() :: { … }`");
  }
  if (first == "clock" && is_word(place.found) && place.expected.starts_with("`->`")) return say(std::string(no_clock));
  if (top && first == "clock") {
    if (of_model(place)) {
      return say("a model program counts steps, and has no clocks: wait step by step, `next next …`");
    }
    return say("a clock is declared in the definition that it belongs to: `Name() :: { clock t; … }`");
  }
  if (!steps) return std::nullopt;
  if (first == "while") {
    return say("`do … maintaining c` runs while c is entailed, `whenever c donext …` again and again");
  }
  if (first == "wait") {
    return say("a wait is a `when`: `when c donext …`; for a time, a clock: `t = 0; when t >= 5 s donext …`");
  }
  if (first == "on" || first == "upon") return did_you_mean("when", first);
  if (first == "parallel" || first == "par") return say("steps between `,` run side by side: `{ a, b }`");
  if (first == "sequence" || first == "seq") return say("steps between `;` follow each other: `{ a; b }`");
  if (first == "loop" || first == "repeat" || first == "forever") {
    return say("`always …` starts a step in every cycle; a definition repeats by calling itself as its last step");
  }
  return std::nullopt;
}

/// Words that say what the place says already: `fault mode burnt`, `with probability 0.1`.
std::optional<Hint> superfluous_hint(const Unexpected& place) {
  const std::string_view last = last_word(place.before);
  if (last == "mode" && first_word(place.before) == "fault" && is_word(place.found)) {
    const std::string name(place.found);
    return Hint{"a fault mode is declared `fault " + name + "`", joined(last, place.found), name};
  }
  if (last != "with" || (place.found != "probability" && place.found != "prob" && place.found != "p")) {
    return std::nullopt;
  }
  const std::string_view rest = without_blank_before(place.behind);
  const std::string_view number = rest.substr(0, rest.find_first_not_of("0123456789.eE"));
  if (number.empty()) return say("a probability is written `with 0.001`");
  return Hint{"a probability is written `with " + std::string(number) + "`", joined(place.found, number),
              std::string(number)};
}

/// What belongs to a mode, in another order or with other signs: `{ x = a; y = b }`, `reward 2 { … }`.
std::optional<Hint> mode_hint(const Unexpected& place) {
  if (place.found == "{" && place.expected.starts_with("`{`, `reward`")) {
    return say("the constraint comes before the reward: `mode m { … } reward 2;`");
  }
  if (place.found == "reward" && place.expected.starts_with("a probability, `,`")) {
    return say("a reward belongs to the mode: `mode m { … } reward 2;`");
  }
  const std::string_view first = first_word(place.before.substr(0, place.before.rfind('{')));
  if (place.found != ";" || place.expected != "`}`" || (first != "mode" && first != "fault")) return std::nullopt;
  const std::string_view next = without_blank_before(place.behind);
  if (next.substr(0, next.find('\n')).find('}') == std::string_view::npos) return std::nullopt;
  if (next.starts_with("}")) return Hint{"no `;` before the `}`", place.found, ""};
  return Hint{"constraints are joined by `&`", place.found, " &"};
}

/// The modes that a transition leaves as a set, `{ a, b } -> c`.
std::optional<Hint> source_hint(const Unexpected& place) {
  if (place.found != "{" || !place.expected.starts_with("a declaration (`input`")) return std::nullopt;
  const std::size_t close = place.behind.find('}');
  if (close == std::string_view::npos || !without_blank_before(place.behind.substr(close + 1)).starts_with("->")) {
    return std::nullopt;
  }
  const std::string modes(without_blank_behind(without_blank_before(place.behind.substr(0, close))));
  return Hint{"the modes that a transition leaves are listed without braces: `" + modes + " -> …`",
              joined(place.found, place.behind.substr(0, close + 1)), modes};
}

/// A unit behind a sample of a scenario: `at 3 s channel "P1" = 2.7 bar`.
std::optional<Hint> sample_hint(const Unexpected& place) {
  const std::size_t end = place.before.find_last_of(";{}");
  const std::string_view statement = place.before.substr(end == std::string_view::npos ? 0 : end + 1);
  const bool sample = first_word(place.before) == "at" && statement.find(" channel ") != std::string_view::npos;
  if (!sample || !is_word(place.found)) return std::nullopt;
  if (place.expected == "`;`") return say("a sample has no unit: it is the number that the channel says");
  if (place.expected.starts_with("a number or a text")) {
    return Hint{"a text is written between quotes: \"" + std::string(place.found) + "\"", place.found,
                '"' + std::string(place.found) + '"'};
  }
  return std::nullopt;
}

/// Words of temporal logic, where a property is claimed.
std::optional<Hint> claim_hint(const Unexpected& place) {
  const bool of_program = place.expected.starts_with("`terminates`");
  if (!of_program && place.expected.find("`reach`") == std::string_view::npos) return std::nullopt;
  constexpr std::array<std::string_view, 5> always{"always", "invariant", "globally", "forall", "holds"};
  if (std::find(always.begin(), always.end(), place.found) != always.end()) {
    return say("that c holds always is `never not (c)`");
  }
  constexpr std::array<std::string_view, 4> reach{"reachable", "reaches", "exists", "possible"};
  if (!of_program && std::find(reach.begin(), reach.end(), place.found) != reach.end()) {
    return did_you_mean("reach", place.found);
  }
  if (!of_program && (place.found == "eventually" || place.found == "finally")) {
    return say("of runs under a program: `program " + std::string(place.found) +
               " …`; of the plant alone: `after c within "
               "5 s d`, or `reach c`");
  }
  return std::nullopt;
}

/// Where two words stand side by side, the first may be no name but a keyword misspelled.
std::optional<Hint> word_before_hint(const Unexpected& place) {
  static const std::vector<std::string> keywords = {"if",       "unless", "when",     "whenever", "always", "next",
                                                    "do",       "choose", "observe",  "control",  "input",  "output",
                                                    "internal", "never",  "finished", "import",   "domain", "initial"};
  const std::string_view word = last_word(place.before);
  const bool relation = place.found == "=" || place.found == "!=" || place.found == "<" || place.found == ">" ||
                        place.found == "<=" || place.found == ">=";
  if (relation && is_reserved(word)) return reserved(word);
  const bool names = place.expected.starts_with("`=`, `!=`") || place.expected.starts_with("`:` and");
  if (!names || !is_word(place.found)) return std::nullopt;
  if (word == "eventually")
    return say("`expect c` is met as soon as c holds, `expect c within 5 s` if that is in time");
  if (const auto near = base::nearest(word, keywords)) return did_you_mean(*near, word);
  if (place.expected.starts_with("`:` and")) {
    return say("an instance is written `" + std::string(place.found) + " : " + std::string(word) + "`");
  }
  return std::nullopt;
}

/// A keyword that is misspelled, cut short, or another language's.
std::optional<Hint> keyword_hint(const Unexpected& place) {
  if (!is_word(place.found)) return std::nullopt;
  if (place.found == "else") {
    return Hint{"did you mean `elsenext`? It belongs to `if … thennext …`", place.found, "elsenext"};
  }
  if (place.found == "elseif" || place.found == "elif") return did_you_mean("elsenext if", place.found);
  if (place.found == "AND") return did_you_mean("and", place.found);
  if (place.found == "OR") return did_you_mean("or", place.found);
  const auto keywords = keywords_in(place.expected);
  if (std::find(keywords.begin(), keywords.end(), place.found) != keywords.end()) {
    return say("each part stands once, in the order " +
               std::string(place.expected.substr(0, place.expected.rfind(" or "))));
  }
  for (const auto& [found, meant] : words) {
    if (found == place.found && std::find(keywords.begin(), keywords.end(), meant) != keywords.end()) {
      return did_you_mean(meant, place.found);
    }
  }
  if (const auto near = base::nearest(place.found, keywords)) return did_you_mean(*near, place.found);
  constexpr std::size_t shortest = 3;
  for (const std::string& keyword : keywords) {
    if (place.found.size() >= shortest && keyword.starts_with(place.found)) return did_you_mean(keyword, place.found);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Hint> hint(const Unexpected& place) {
  for (const auto& find :
       {sample_hint, time_hint, unit_hint, foreign_hint, sign_hint, value_hint, reserved_hint, superfluous_hint,
        mode_hint, source_hint, claim_hint, statement_hint, word_before_hint, keyword_hint}) {
    if (auto found = find(place)) return found;
  }
  return std::nullopt;
}

}  // namespace rmpl::grammar
