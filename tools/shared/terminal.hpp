// What the programs show: results on standard output, all else on standard error, in colour or not.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "base/painter.hpp"

namespace rmpl::tools {

enum class Color { automatic, always, never };

/// The colours of standard output and of standard error. `automatic` is colour on a terminal, unless
/// NO_COLOR is set or mpirun has made the terminal.
base::Painter output_painter(Color color);
base::Painter error_painter(Color color);

/// To standard output, at once. Throws base::InputError with the reason where it does not get there in full.
void print(std::string_view text);

/// Whether standard output is a terminal that somebody sees, not one of mpirun.
bool output_is_seen();

/// To standard error, as it is.
void print_error(std::string_view text);
/// `program: text` and the end of the line, to standard error. Characters that would steer a terminal are escaped.
void tell(std::string_view text);

/// The program's name in what is told.
void name_program(std::string name);

}  // namespace rmpl::tools
