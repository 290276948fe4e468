// Verdicts, and what they rest on.
// SPDX-License-Identifier: MIT
#include "verifier/verdict/answer.hpp"

#include <algorithm>

namespace rmpl::verifier {

Verdict overall(const std::vector<Answer>& answers) {
  const auto some = [&](Verdict verdict) {
    return std::any_of(answers.begin(), answers.end(), [&](const Answer& a) { return a.verdict == verdict; });
  };
  if (some(Verdict::violated)) return Verdict::violated;
  return some(Verdict::undecided) ? Verdict::undecided : Verdict::holds;
}

}  // namespace rmpl::verifier
