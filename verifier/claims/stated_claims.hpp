// What a file of properties claims of a plant and its program: the questions to decide, and the claims with their
// answers. SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/property.hpp"
#include "verifier/property/property.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/verdict/answer.hpp"
#include "verifier/verdict/subject.hpp"
#include "verifier/verdict/table.hpp"

namespace rmpl::verifier {

/// Whether it claims a probability, which no search for a witness decides.
bool is_measured(const automata::PlantProperty& property);

class StatedClaims {
 public:
  /// Along with claims on a program it is asked whether a run of it gets stuck, once for all that leave the same things
  /// free, unless a property claims just that. `bounds` are repeated by the answers.
  StatedClaims(const Subject& subject, std::vector<automata::PlantProperty> stated, const Bounds& bounds);

  /// What searches decide, to be decided together (closed_loop/check_all.hpp).
  [[nodiscard]] const std::vector<Question>& questions() const { return questions_; }

  /// Every claim with its answer: those of the questions, one by one, and of probabilities those that are worked out
  /// here. Throws base::InputError where time as the file has it gives no probability.
  [[nodiscard]] std::vector<Claim> with(std::vector<Answer> answers, const Limits& limits) const;

 private:
  Subject subject_;
  std::vector<automata::PlantProperty> stated_;
  Bounds bounds_;
  std::vector<Question> questions_;
};

}  // namespace rmpl::verifier
