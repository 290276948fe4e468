// The sink of diagnostics.
// SPDX-License-Identifier: MIT
#include "grammar/source/diagnostic.hpp"

#include <algorithm>
#include <tuple>

namespace rmpl::grammar {

const char* to_string(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "";
}

void Diagnostics::add(Diagnostic diagnostic) {
  if (diagnostic.severity == Severity::error) ++errors_;
  all_.push_back(std::move(diagnostic));
}

Diagnostic& Diagnostics::error(Code code, Span span, std::string message) {
  add({code, Severity::error, span, std::move(message), {}, {}, {}});
  return all_.back();
}

Diagnostic& Diagnostics::warning(Code code, Span span, std::string message) {
  add({code, Severity::warning, span, std::move(message), {}, {}, {}});
  return all_.back();
}

Diagnostic& Diagnostics::note(Code code, Span span, std::string message) {
  add({code, Severity::note, span, std::move(message), {}, {}, {}});
  return all_.back();
}

std::vector<Diagnostic> Diagnostics::sorted() const {
  std::vector<Diagnostic> sorted = all_;
  const auto key = [](const Diagnostic& d) { return std::tie(d.span, d.code, d.message); };
  std::stable_sort(sorted.begin(), sorted.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  return sorted;
}

}  // namespace rmpl::grammar
