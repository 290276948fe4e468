// What is wrong with an input, where, and what to do about it; and the sink that collects all of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "grammar/source/codes.hpp"
#include "grammar/source/span.hpp"

namespace rmpl::grammar {

/// Least severe first, so that levels can be compared.
enum class Severity { note, warning, error };

/// `error`, `warning`, `note`.
const char* to_string(Severity severity);

/// A second place to blame, with its own message.
struct Note {
  Span span;
  std::string message;
  bool operator==(const Note&) const = default;
};

/// A stretch of text and what to put in its place; an empty stretch is a place to insert at.
struct Edit {
  Span span;
  std::string text;
  bool operator==(const Edit&) const = default;
};

/// One finding. Messages are lower case, name the thing and what was expected, and end without a full stop.
struct Diagnostic {
  Code code = Code::syntax;
  Severity severity = Severity::error;
  Span span;
  std::string message;
  std::vector<Note> notes;
  std::optional<std::string> suggestion;  ///< the fix, as a sentence: "did you mean `engine`?"
  std::vector<Edit> fix;                  ///< what does as the suggestion says, where that is certain; in order, apart
  bool operator==(const Diagnostic&) const = default;
};

/// Collects diagnostics; passes go on after an error and report all.
class Diagnostics {
 public:
  void add(Diagnostic diagnostic);
  /// Adds an error and returns it, for notes and a suggestion. The reference lasts until the next addition.
  Diagnostic& error(Code code, Span span, std::string message);
  Diagnostic& warning(Code code, Span span, std::string message);
  Diagnostic& note(Code code, Span span, std::string message);

  [[nodiscard]] std::size_t error_count() const { return errors_; }
  [[nodiscard]] bool has_errors() const { return errors_ > 0; }
  [[nodiscard]] bool empty() const { return all_.empty(); }
  /// In the order in which they were added.
  [[nodiscard]] const std::vector<Diagnostic>& all() const { return all_; }
  /// By file, then place, then code; equals once.
  [[nodiscard]] std::vector<Diagnostic> sorted() const;

 private:
  std::vector<Diagnostic> all_;
  std::size_t errors_ = 0;
};

/// A finding that a comment in the source allows, and the reason that it gives.
struct AllowedFinding {
  Diagnostic finding;
  std::string reason;
  Span comment;
};

}  // namespace rmpl::grammar
