// The extensions of one system state by one step, best first: the OCSP of thesis Fig. 6-11, step 3.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/estimate/component_moves.hpp"
#include "runtime/reasoning/estimate/open_readings.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"

namespace rmpl::runtime {

/// What is known at once of the observation factor of all modes near some `base`, beside what components leave open by
/// themselves: it is `most` at most for these, and a component that is in another mode multiplies it by `gains`, by
/// component, at most: the readings that its mode in the base may be needed to leave open.
struct FactorBound {
  double most = 1;
  std::vector<double> gains;
};

/// The same of all readings, by the modes of those components that gain anything: a mode that leaves the readings open
/// by itself gains nothing.
struct NearbyFactors {
  double most = 1;
  std::map<std::size_t, std::vector<double>> gains;
};

/// What one observation says of candidate states. Decision variables are components, their values modes, so that what
/// is learnt about one source state holds for all.
class ReadingEvidence {
 public:
  /// `lasting` holds the conflicts that need no observation; those found here are added to it.
  /// `open`, what is known of open readings, is null where the factor is not applied.
  ReadingEvidence(automata::PlantStep& step, automata::Observation observation, ConflictSet& lasting,
                  OpenReadings* open);

  /// The observation factor of semantics 4; 0 where modes and observation are jointly inconsistent.
  double factor(const automata::Modes& modes);
  /// The mode assignments to blame for a factor of 0.
  Conflict blame(const automata::Modes& modes);
  /// What is known of components by themselves, in whatever modes the others are.
  const OpeningFactors& opening_factors();
  /// Of modes near `base`, beside these. Remembered: sources with a running clock ask in each cycle.
  [[nodiscard]] const FactorBound& factor_bound(const automata::Modes& base);
  [[nodiscard]] NearbyFactors nearby_factors(const automata::Modes& base) const;
  /// What the factor of any modes is at most: each reading that no modes imply costs them its 1/m.
  [[nodiscard]] double greatest_factor() const;
  /// Whether it says more than that no factor is above 1.
  [[nodiscard]] bool bounds_factors() const { return open_ != nullptr && !observation_.empty(); }
  /// How many modes a component has.
  [[nodiscard]] std::size_t modes_of(std::size_t component) const {
    return step_.plant().components[component].modes.size();
  }
  /// All that is known to be inconsistent with this observation.
  [[nodiscard]] const std::shared_ptr<ConflictSet>& conflicts() const { return conflicts_; }

 private:
  /// Without the readings that `counted` counts; of all where it is null.
  [[nodiscard]] FactorBound factor_bound(const automata::Modes& base, const OpeningFactors* counted) const;

  automata::PlantStep& step_;
  automata::Observation observation_;
  ConflictSet& lasting_;
  OpenReadings* open_;
  std::shared_ptr<ConflictSet> conflicts_;
  std::optional<OpeningFactors> opening_factors_;
  std::unordered_map<automata::Modes, FactorBound, automata::ModesHash>
      bounds_;  ///< by base; looked up, never iterated
};

/// One target of a step. `prior` is P_T, the product of the moves' probabilities in order of component; `factor` the
/// observation factor, above 0; `bound` what both together are at most, for this target and all that are found later.
struct Extension {
  automata::Modes modes;
  double prior;
  double factor;
  double bound;
};

/// The consistent extensions of a source, found as far as somebody asks. They depend on the moves and the observation
/// alone. Their order is that of the prior; once it was tightened, that of an upper bound of prior and factor together,
/// which is a product over the components, as the prior is: what a mode may gain in factor is taken off its cost.
class Extensions {
 public:
  /// `moves`: per component. Evidence and moves must outlive this.
  Extensions(ReadingEvidence& evidence, const std::vector<const ComponentMoves*>& moves) { restart(evidence, moves); }
  /// The same with moves of its own, as PlantStep gives them.
  Extensions(ReadingEvidence& evidence, const std::vector<std::vector<automata::Move>>& moves);
  /// Begins anew with other moves, in the memory of the last.
  void restart(ReadingEvidence& evidence, const std::vector<const ComponentMoves*>& moves);

  /// Those found so far.
  [[nodiscard]] const std::vector<Extension>& found() const { return found_; }
  /// Checks one candidate that holds no known conflict, if there is one; a consistent one is added to `found`.
  void check_one();
  /// Prior times factor of the i-th extension and of all after it are at most this (up to rounding); 0 where there is
  /// none.
  [[nodiscard]] double bound(std::size_t i) const;
  /// Takes the observation factor into account from now on; where that changes something, nothing counts as found.
  /// Worth its while where a search goes on for long. Whether it changes something.
  bool tighten();
  /// An upper bound of prior times factor summed over all extensions; and what of it is the share of one, once the mass
  /// was asked for.
  double mass();
  /// Whether anything is known of the factors, once it was asked to tighten or for the mass; else each is 1 at most.
  [[nodiscard]] bool informed() const { return openings_ != nullptr; }
  [[nodiscard]] double share(const automata::Modes& modes, double prior) const;
  /// Prior times factor of an extension are at most the product of the greatest factor and of what each of its modes
  /// promises. In these terms `share` is that product.
  [[nodiscard]] double greatest_factor() const { return factors_.most; }
  [[nodiscard]] double promise(std::size_t component, automata::ModeId mode) const {
    return prior(component, mode) * gain(component, mode);
  }
  /// What the factor gains by the mode, at most, or loses, at least.
  [[nodiscard]] double gain(std::size_t component, automata::ModeId mode) const {
    if (!informed()) return 1;
    const double gain = mode == base_[component] ? 1 : factors_.gains[component];
    return gain * openings_->of(component, mode);
  }
  /// Whether a component may move as in the other, and promises the same by it; false also where telling takes longer.
  [[nodiscard]] bool moves_as(const Extensions& other, std::size_t component) const {
    const bool same = moves_[component] == other.moves_[component] && openings_ == other.openings_;
    return same && (!informed() || factors_.gains[component] == other.factors_.gains[component]);
  }
  /// The modes that a component may move to, likeliest first.
  [[nodiscard]] std::span<const OptimalSearch::PricedValue> choices(std::size_t component) const {
    return moves_[component]->domain().choices();
  }
  /// The probability of moving to exactly these modes, before the observation.
  [[nodiscard]] double prior(const automata::Modes& modes) const {
    double product = 1;
    for (std::size_t c = 0; c < modes.size() && product > 0; ++c) product *= prior(c, modes[c]);
    return product;
  }
  [[nodiscard]] double prior(std::size_t component, automata::ModeId mode) const {
    return moves_[component]->prior(mode);
  }
  [[nodiscard]] const ComponentMoves& moves(std::size_t component) const { return *moves_[component]; }
  /// What is known to be inconsistent.
  [[nodiscard]] const std::vector<Conflict>& conflicts() const { return evidence_->conflicts()->conflicts(); }
  /// How many candidates were checked.
  [[nodiscard]] std::size_t checked() const { return started_ ? search_.checked() : 0; }

 private:
  void start();
  void look_at_factors();
  [[nodiscard]] bool adjusts() const { return tight_ && informed(); }
  void adjust(std::vector<const OptimalSearch::Domain*>& domains);
  [[nodiscard]] double bound_of(double cost) const;

  ReadingEvidence* evidence_ = nullptr;
  std::vector<const ComponentMoves*> moves_;  ///< by component
  std::vector<ComponentMoves> own_;           ///< where nobody else has them
  double best_ = 1;                           ///< no extension is worth more
  double mass_ = 1;
  bool started_ = false;                      ///< most sources are too unlikely for a search ever to begin
  bool tight_ = false;                        ///< `tighten` was called
  bool looked_ = false;                       ///< whether the next three are worked out:
  automata::Modes base_;                      ///< the likeliest modes,
  FactorBound factors_;                       ///< what is known of the factors near them,
  const OpeningFactors* openings_ = nullptr;  ///< and of those of single components; null: nothing of either
  double offset_ = 0;                         ///< cost of what no choice can change
  std::vector<WeightedDomain> adjusted_;
  OptimalSearch search_{{}};
  std::vector<Extension> found_;
};

}  // namespace rmpl::runtime
