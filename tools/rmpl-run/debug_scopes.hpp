// What a debugger shows has its place in scopes.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "automata/json/parse.hpp"

namespace rmpl::tools {

/// The references of the scopes, which are all that has variables.
enum class DebugScope { decided = 1, belief, truth, readings, ahead };

/// A text among the arguments of a request; nothing where there is none. Throws base::InputError where it is none.
std::optional<std::string> text_argument(const automata::Json& arguments, const char* key);

}  // namespace rmpl::tools
