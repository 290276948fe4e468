// Assignments as people read them: `name = value`.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "automata/plant.hpp"

namespace rmpl::automata {

/// "name = value".
std::string to_text(const Variables& variables, const Assignment& assignment);

/// One after the other; "" where there are none.
std::string to_text(const Variables& variables, std::span<const Assignment> assignments,
                    std::string_view separator = ", ");

/// "name = mode".
std::string to_text(const Component& component, ModeId mode);

}  // namespace rmpl::automata
