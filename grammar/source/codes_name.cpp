// Codes of the registry: names, domains and values.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array table = {
    CodeInfo{Code::unknown_name, "unknown name",
             "Nothing of this name is declared here: no variable, mode, value, domain, type, definition or instance, "
             "whichever the place needs. Where a declared name is near, it is suggested.",
             "mode off { thurst = zero };", "mode off { thrust = zero };"},
    CodeInfo{Code::duplicate_name, "name defined twice",
             "Two things of one kind have the same name in the same scope. The note shows the first one.",
             "mode off;\nmode off;", "mode off;\nmode standby;"},
    CodeInfo{Code::value_outside_domain, "value outside the domain",
             "The variable never has this value: it is not in its domain.",
             "output thrust : { zero, full };\nmode on { thrust = half };",
             "output thrust : { zero, half, full };\nmode on { thrust = half };"},
    CodeInfo{Code::different_domains, "variables of different domains",
             "Two variables can be equal only where their domains list the same values in the same order.",
             "input a : { on, off };\ninput b : { off, on };\nmode m { a = b };",
             "domain Switch = { on, off };\ninput a, b : Switch;\nmode m { a = b };"},
    CodeInfo{
        Code::ambiguous_name, "both a value and a variable",
        "The name on the right is a value of the variable on the left, and also a variable of the same domain. The "
        "constraint would mean different things; rename one of them.",
        "input a : { low, high };\ninput low : { low, high };\nmode m { a = low };",
        "input a : { low, high };\ninput bound : { low, high };\nmode m { a = low };"},
    CodeInfo{Code::empty_domain, "domain without values", "A variable needs at least one value that it can have.",
             "domain Level = { };", "domain Level = { low, high };"},
    CodeInfo{Code::wrong_kind_of_name, "name of another kind",
             "The name is declared, but as something else than this place needs: a module where a component type was "
             "expected, a mode variable where an attribute was, and so on.",
             "engine : Level;  // Level is a domain", "engine : Engine;"},
};

}  // namespace

std::span<const CodeInfo> name_codes() { return table; }

}  // namespace rmpl::grammar
