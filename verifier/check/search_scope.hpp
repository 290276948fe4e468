// Search scopes: where a question is searched, the whole plant or its cone as a plant of its own.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "verifier/behaviour/situation.hpp"
#include "verifier/check/wanted.hpp"
#include "verifier/property/fault.hpp"
#include "verifier/slice/part.hpp"
#include "verifier/symmetry/symmetry.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// A plant with a question in its terms, the situations of the one and the symmetries of both.
class SearchScope {
 public:
  /// What is the same for every scope of a check.
  struct Terms {
    TimeModel time;  ///< of the whole plant, so that all speak of the same units
    const CheckOptions& options;
    unsigned faults;
    Meter& meter;
  };

  /// The whole plant. Keeps references to the step function and the meter.
  SearchScope(automata::PlantStep& whole, const Wanted& wanted, const Terms& terms);
  /// A part of it, while all others are in `rest`. Keeps a reference to the meter.
  SearchScope(Part part, automata::Modes rest, const Wanted& wanted, const Terms& terms);

  [[nodiscard]] automata::PlantStep& step() { return step_; }
  /// In the terms of the scope.
  [[nodiscard]] const Wanted& wanted() const { return wanted_; }
  [[nodiscard]] const std::vector<automata::Assignment>& from() const { return from_; }
  [[nodiscard]] Situations& situations() { return situations_; }
  [[nodiscard]] const Symmetry& symmetry() const { return symmetry_; }
  /// Possible modes to start in.
  [[nodiscard]] const std::vector<automata::Modes>& start() const { return start_; }
  [[nodiscard]] bool is_whole() const { return !part_; }

  /// A run, and faults, in the terms of the whole plant.
  [[nodiscard]] Witness out(Witness witness) const;
  [[nodiscard]] std::vector<Fault> out(std::vector<Fault> faults) const;

 private:
  SearchScope(std::unique_ptr<const Part> part, automata::Modes rest, automata::PlantStep* whole, const Wanted& wanted,
              const Terms& terms);

  std::unique_ptr<const Part> part_;
  automata::Modes rest_;
  std::optional<automata::PlantStep> own_;
  automata::PlantStep& step_;
  Wanted wanted_;
  std::vector<automata::Assignment> from_;
  Situations situations_;
  std::vector<automata::Modes> start_;
  Symmetry symmetry_;
};

}  // namespace rmpl::verifier
