// Diagnostics as workflow commands of GitHub Actions, which annotate the lines of a pull request.
// SPDX-License-Identifier: MIT
#include <string_view>

#include "base/printable.hpp"
#include "grammar/source/render.hpp"

namespace rmpl::grammar {
namespace {

/// The escapes of GitHub's own toolkit (`@actions/core`, command.ts); of a property, `:` and `,` too. A log is read on
/// a terminal, too: what would steer it is escaped before.
std::string escaped(std::string_view text, bool property) {
  std::string result;
  for (const char c : base::printable(text)) {
    if (c == '%') {
      result += "%25";
    } else if (c == '\n') {
      result += "%0A";
    } else if (property && c == ':') {
      result += "%3A";
    } else if (property && c == ',') {
      result += "%2C";
    } else {
      result += c;
    }
  }
  return result;
}

std::string command_of(Severity severity) { return severity == Severity::note ? "notice" : to_string(severity); }

std::string place_of(Span span, const Sources& sources) {
  const SourceFile& file = sources[span.file];
  const Place begin = file.place(span.begin);
  const Place end = file.place(span.end);
  std::string text = "file=" + escaped(file.name(), true) + ",line=" + std::to_string(begin.line) +
                     ",endLine=" + std::to_string(end.line);
  // GitHub takes columns within one line only; its end is inclusive.
  if (begin.line != end.line) return text;
  const std::uint32_t last = end.column > begin.column ? end.column - 1 : begin.column;
  return text + ",col=" + std::to_string(begin.column) + ",endColumn=" + std::to_string(last);
}

std::string message_of(const Diagnostic& diagnostic, const Sources& sources) {
  std::string text = diagnostic.message;
  for (const Note& note : diagnostic.notes) {
    const SourceFile& file = sources[note.span.file];
    text += "\n" + file.name() + ":" + std::to_string(file.place(note.span.begin).line) + ": " + note.message;
  }
  if (diagnostic.suggestion) text += "\nhelp: " + *diagnostic.suggestion;
  return text;
}

std::string command(Severity severity, const std::string& place, const std::string& title, const std::string& message) {
  return "::" + command_of(severity) + " " + place + ",title=" + escaped(title, true) + "::" + escaped(message, false) +
         "\n";
}

}  // namespace

std::string github_command(Severity severity, const std::string& file, std::uint32_t line, const std::string& title,
                           const std::string& message) {
  const std::string place = "file=" + escaped(file, true) + (line > 0 ? ",line=" + std::to_string(line) : "");
  return command(severity, place, title, message);
}

std::string render_github(std::span<const Diagnostic> diagnostics, const Sources& sources) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    const std::string title = to_string(diagnostic.code) + ": " + std::string(info(diagnostic.code).title);
    text += command(diagnostic.severity, place_of(diagnostic.span, sources), title, message_of(diagnostic, sources));
  }
  return text;
}

}  // namespace rmpl::grammar
