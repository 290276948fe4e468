// Verdicts, and what they rest on.
// SPDX-License-Identifier: MIT
#include "verifier/verdict/answer.hpp"

namespace rmpl::verifier {

bool is_warning(const Property& property) {
  const auto* asked = std::get_if<ProgramProperty>(&property);
  return asked != nullptr && asked->warning;
}

Verdict overall(const std::vector<Property>& properties, const std::vector<Answer>& answers) {
  const auto some = [&](Verdict verdict) {
    for (std::size_t p = 0; p < answers.size(); ++p) {
      if (!is_warning(properties[p]) && answers[p].verdict == verdict) return true;
    }
    return false;
  };
  if (some(Verdict::violated)) return Verdict::violated;
  return some(Verdict::undecided) ? Verdict::undecided : Verdict::holds;
}

}  // namespace rmpl::verifier
