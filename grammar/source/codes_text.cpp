// Codes of the registry: what is wrong with a text as such.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array table = {
    CodeInfo{
        Code::syntax, "syntax error",
        "The text does not follow the grammar at this place. The message says what could have stood there and what "
        "was found. After an error the reader goes on behind the next `;` or `}`, so that one run reports them all.",
        R"(EntrySequence() :: {
  when att = entry-orient do lander = separated
})",
        R"(EntrySequence() :: {
  when att = entry-orient donext lander = separated
})"},
    CodeInfo{
        Code::invalid_encoding, "not UTF-8 text",
        "Sources are UTF-8 text without NUL bytes. This place holds a NUL, or bytes that are no UTF-8: perhaps the "
        "file is in another encoding, or it is no text at all.",
        "// caf\\xE9, written in Latin-1", "// café, written in UTF-8"},
    CodeInfo{Code::nesting_too_deep, "nested too deep",
             "Constraints and steps may nest 400 levels deep. No model that a person reads comes near; the limit keeps "
             "a text that a program wrote from exhausting the stack. Name parts of it: definitions, or internal "
             "attributes with a constraint each.",
             "when ((((…400 more…((x = on))…)))) donext y = off", "when x = on donext y = off"},
    CodeInfo{Code::number_out_of_range, "number out of range",
             "The number is too large: a decimal goes up to 1.8e308, a whole number up to 2^64 - 1.",
             "seed 99999999999999999999;", "seed 7;"},
    CodeInfo{
        Code::duration_out_of_range, "duration out of range",
        "A duration is between 0 and about 292 years, and no finer than a nanosecond. Units are us, ms, s, min (or "
        "mins), h and d; a bare number is seconds.",
        "off -> on after 1000000 d;", "off -> on after 30 d;"},
    CodeInfo{Code::import_not_found, "import not found",
             "The imported file cannot be read. The path is taken relative to the file that imports it.",
             R"(import "valves.tcca";  // the file is called valve.tcca)", R"(import "valve.tcca";)"},
    CodeInfo{Code::import_cycle, "files import each other",
             "A file imports itself, directly or by way of others. Put what both need into a third file.",
             R"(// a.tcca
import "b.tcca";
// b.tcca
import "a.tcca";)",
             R"(// a.tcca
import "types.tcca";
// b.tcca
import "types.tcca";)"},
    CodeInfo{Code::too_many_errors, "too many syntax errors",
             "After a hundred syntax errors the rest of the text is not read. Is it in the language that the file's "
             "ending says?",
             "(a picture, named plant.tcca)", "(a plant model, named plant.tcca)"},
    CodeInfo{Code::text_too_long, "text too long", "A source text may have 4 GiB - 1 bytes.", "(a text of 5 GiB)",
             "(the same in several files that import each other)"},
    CodeInfo{
        Code::too_large, "model too large",
        "A few lines can ask for more than any machine holds: a module of ten modules of ten modules, and so on. A "
        "plant may have four million values, modes and transitions altogether.",
        "module A { a, b, c, d : B; }  // B holds four C, and so on, twenty times", "module A { a, b, c, d : Valve; }"},
};

}  // namespace

std::span<const CodeInfo> text_codes() { return table; }

}  // namespace rmpl::grammar
