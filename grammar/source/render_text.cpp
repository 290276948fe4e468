// Diagnostics as text, in the manner of rustc: headline, place, line with carets, notes, help.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/painter.hpp"
#include "base/printable.hpp"
#include "base/utf8.hpp"
#include "grammar/source/render.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::size_t widest = 120;  // columns of a source line that are shown
constexpr std::size_t lead_in = 30;  // columns shown before the span where a line is wider
constexpr std::size_t tab_columns = 4;

std::string painted(const base::Painter& painter, Severity severity, const std::string& text) {
  switch (severity) {
    case Severity::error:
      return painter.bad(text);
    case Severity::warning:
      return painter.doubtful(text);
    case Severity::note:
      return painter.note(text);
  }
  return text;
}

/// A message whose words are all of a length that people read: a name of a megabyte says no more than its beginning.
std::string shortened(const std::string& whole) {
  constexpr std::size_t longest = 200;
  const std::string message = base::printable(whole);
  std::string text;
  for (std::size_t at = 0; at < message.size();) {
    const std::size_t end = std::min(message.find(' ', at), message.size() - 1) + 1;
    if (end - at <= longest) {
      text += message.substr(at, end - at);
    } else {
      std::size_t cut = at + longest / 2;
      while (base::is_continuation(message[cut])) ++cut;  // not within a code point
      text += message.substr(at, cut - at) + "… ";
    }
    at = end;
  }
  return text;
}

/// A source line as it is shown, with the columns that are marked.
struct Excerpt {
  std::string text;
  std::size_t marked_from = 0;  ///< columns of `text`, counted in code points
  std::size_t marked_to = 0;
};

/// The part of a long line around its byte `begin`, cut between code points: enough bytes for what is shown.
struct Window {
  std::size_t first = 0;
  std::size_t last = 0;

  Window(std::string_view line, std::size_t begin) : last(line.size()) {
    constexpr std::size_t longest_code_point = 4;
    const auto within = [&](std::size_t at) { return at < line.size() && base::is_continuation(line[at]); };
    if (begin > 2 * widest * longest_code_point) first = begin - 2 * widest * longest_code_point;
    while (within(first)) ++first;
    last = std::min(last, begin + 2 * widest * longest_code_point);
    while (within(last)) ++last;
  }
};

/// Renders the bytes [begin, end) of a line and marks them; a line that is too wide is shown through a window.
/// Costs the same for a line of any length.
Excerpt excerpt(std::string_view whole, std::size_t begin, std::size_t end) {
  const Window window(whole, begin);
  const std::string_view line = whole.substr(window.first, window.last - window.first);
  begin -= window.first;
  end = std::min(end - window.first, line.size());
  // One cell per column: a code point, or a part of a tab or of the escape of what is not shown as it is.
  std::vector<std::string> cells;
  std::size_t from = 0;
  std::size_t to = 0;
  for (std::size_t at = 0; at < line.size();) {
    if (at <= begin) from = cells.size();
    const std::size_t length = base::code_point_length(line.substr(at));
    if (line[at] == '\t') {
      cells.resize(cells.size() + tab_columns, " ");
    } else {
      const std::string_view one = line.substr(at, std::max<std::size_t>(1, length));
      if (const std::string escaped = base::printable(one); escaped == one) {
        cells.emplace_back(one);
      } else {
        for (const char c : escaped) cells.emplace_back(1, c);
      }
    }
    at += std::max<std::size_t>(1, length);
    if (at <= end) to = cells.size();
  }
  if (begin >= line.size()) from = cells.size();
  to = std::max(to, from + 1);

  Excerpt shown;
  const bool wide = cells.size() > widest || line.size() < whole.size();
  const std::size_t first = wide && from > lead_in ? from - lead_in : 0;
  const std::size_t last = std::min(cells.size(), first + widest);
  const bool cut_before = window.first > 0 || first > 0;
  const bool cut_behind = window.last < whole.size() || last < cells.size();
  if (cut_before) shown.text = "…";
  for (std::size_t i = first; i < last; ++i) shown.text += cells[i];
  if (cut_behind) shown.text += "…";
  const std::size_t shift = cut_before ? 1 : 0;
  shown.marked_from = from - first + shift;
  shown.marked_to = std::min(to, std::max(last, from + 1)) - first + shift;
  return shown;
}

class Text {
 public:
  Text(const Sources& sources, bool color) : sources_(sources), painter_{color} {}

  void add(const Diagnostic& diagnostic) {
    margin_ = std::string(digits(diagnostic), ' ');
    const std::string kind = std::string(to_string(diagnostic.severity)) + "[" + to_string(diagnostic.code) + "]";
    out_ += painted(painter_, diagnostic.severity, kind) + painter_.strong(": " + shortened(diagnostic.message)) + "\n";
    add_place(diagnostic.span, [&](std::size_t width, const std::string& more) {
      return painted(painter_, diagnostic.severity, std::string(width, '^') + more);
    });
    for (const Note& note : diagnostic.notes) {
      out_ += painter_.note("note") + painter_.strong(": " + shortened(note.message)) + "\n";
      add_place(note.span, [&](std::size_t width, const std::string& more) {
        return painter_.place(std::string(width, '-') + more);
      });
    }
    if (diagnostic.suggestion)
      out_ += painter_.good("help") + painter_.strong(": " + shortened(*diagnostic.suggestion)) + "\n";
    out_ += "\n";
  }

  [[nodiscard]] std::string take() { return std::move(out_); }

 private:
  /// The width of the greatest line number that this diagnostic shows.
  [[nodiscard]] std::size_t digits(const Diagnostic& diagnostic) const {
    const auto line = [&](Span span) { return sources_[span.file].place(span.begin).line; };
    std::uint32_t greatest = line(diagnostic.span);
    for (const Note& note : diagnostic.notes) greatest = std::max(greatest, line(note.span));
    return std::to_string(greatest).size();
  }

  /// `mark` draws what stands under a span, by its width.
  template <class Mark>
  void add_place(Span span, const Mark& mark) {
    const SourceFile& file = sources_[span.file];
    const Place place = file.place(span.begin);
    out_ += margin_ + painter_.place("-->") + " " + base::printable(file.name()) + ":" + std::to_string(place.line) +
            ":" + std::to_string(place.column) + "\n";
    if (file.text().empty()) return;

    const std::string_view line = file.line(place.line);
    const std::size_t begin = span.begin - file.line_start(place.line);
    const std::size_t end = std::max<std::size_t>(begin, span.end - file.line_start(place.line));
    const Excerpt shown = excerpt(line, begin, std::min(end, line.size()));
    const std::string number = std::to_string(place.line);
    const std::string bar = margin_ + painter_.place(" |");
    // The mark of a span that goes on in the next line says so.
    const std::string more = end > line.size() + 1 ? "…" : "";
    out_ += bar + "\n";
    out_ += painter_.place(std::string(margin_.size() - number.size(), ' ') + number + " |") + " " + shown.text + "\n";
    out_ += bar + " " + std::string(shown.marked_from, ' ') + mark(shown.marked_to - shown.marked_from, more) + "\n";
  }

  const Sources& sources_;
  base::Painter painter_;
  std::string margin_;
  std::string out_;
};

}  // namespace

std::string render_text(std::span<const Diagnostic> diagnostics, const Sources& sources, bool color) {
  Text text(sources, color);
  for (const Diagnostic& diagnostic : diagnostics) text.add(diagnostic);
  return text.take();
}

std::string render_text(const Findings& findings, bool color) {
  return render_text(findings.diagnostics.sorted(), findings.sources, color);
}

}  // namespace rmpl::grammar
