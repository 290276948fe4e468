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

/// To standard output, at once. Each throws base::InputError with the reason where it does not get there in full.
///
/// A text for people: what would steer a terminal is escaped, but for the colours of `Painter`.
void print(std::string_view text);
/// A JSON document, or lines of JSON: the same, by escapes of JSON that leave its values what they are.
void print_json(std::string_view document);
/// A file, byte by byte; escaped as a text for people where somebody sees it on a terminal.
void print_file(std::string_view text);
/// As it is, whatever it does to a terminal.
void print_raw(std::string_view text);

/// Whether anything was printed, or tried to be.
bool output_is_begun();

/// Whether standard output is a terminal that somebody sees, not one of mpirun.
bool output_is_seen();

/// To standard error, a text for people.
void print_error(std::string_view text);
/// `program: text` and the end of the line, to standard error.
void tell(std::string_view text);

/// The program's name in what is told.
void name_program(std::string name);

}  // namespace rmpl::tools
