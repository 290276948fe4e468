// Sums of probabilities, by proof where guards decide what applies together.
// SPDX-License-Identifier: MIT
#include "compiler/check/probabilities.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>
#include <optional>

#include "automata/logic/theory.hpp"
#include "compiler/check/vocabulary.hpp"

namespace rmpl::compiler {

using automata::Formula;
using automata::Transition;
using automata::Weight;
using grammar::Code;

namespace {

/// Searches for fault transitions of one mode that sum above 1 and whose guards can hold together. Depth first over
/// "take it or leave it", heaviest first; a branch ends where the rest cannot reach 1, or where the guards contradict.
class Overfull {
 public:
  Overfull(const automata::Plant& type, automata::ModeId mode, std::vector<std::size_t> faults)
      : component_(type.components.front()), theory_(type.variables), faults_(std::move(faults)) {
    theory_.tell(component_.modes[mode.index()].constraint);
    std::stable_sort(faults_.begin(), faults_.end(),
                     [&](std::size_t a, std::size_t b) { return weight(a) > weight(b); });
    rest_.resize(faults_.size() + 1, 0);
    for (std::size_t i = faults_.size(); i > 0; --i) rest_[i - 1] = rest_[i] + weight(faults_[i - 1]);
  }

  /// Positions of transitions in order, or nothing where there are none. A search that takes too long finds nothing.
  std::optional<std::vector<std::size_t>> find() {
    if (!search(0, 0)) return std::nullopt;
    std::sort(taken_.begin(), taken_.end());
    return taken_;
  }

 private:
  [[nodiscard]] double weight(std::size_t transition) const { return component_.transitions[transition].weight.value; }

  bool search(std::size_t next, double sum) {
    if (sum > 1 + probability_tolerance) return true;
    if (next == faults_.size() || sum + rest_[next] <= 1 + probability_tolerance || --patience_ == 0) return false;
    taken_.push_back(faults_[next]);
    if (compatible() && search(next + 1, sum + weight(faults_[next]))) return true;
    taken_.pop_back();
    return search(next + 1, sum);
  }

  bool compatible() {
    std::vector<Formula> guards;
    for (const std::size_t t : taken_) {
      if (!component_.transitions[t].guard.is_true()) guards.push_back(component_.transitions[t].guard);
    }
    return guards.empty() || theory_.allows({}, theory_.encode(automata::conjunction(std::move(guards))));
  }

  const automata::Component& component_;
  automata::Theory theory_;
  std::vector<std::size_t> faults_;  ///< positions of transitions, heaviest first
  std::vector<double> rest_;         ///< the sum of the weights from here on
  std::vector<std::size_t> taken_;
  std::size_t patience_ = 1000;
};

}  // namespace

std::string decimal(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 6);
  return {buffer.data(), end.ptr};
}

bool check_probability(const grammar::Number& probability, grammar::Diagnostics& diagnostics) {
  if (probability.value >= 0 && probability.value <= 1) return true;
  diagnostics.error(Code::probability_out_of_range, probability.span,
                    "the probability " + probability.text + " is outside [0, 1]");
  return false;
}

void check_branch_sum(const grammar::TransitionText& text, grammar::Diagnostics& diagnostics) {
  double sum = 0;
  for (const grammar::Branch& branch : text.branches) {
    if (!branch.weight) continue;
    if (const auto* weight = std::get_if<grammar::ProbabilityWeight>(&*branch.weight)) sum += weight->probability.value;
  }
  if (sum <= 1 + probability_tolerance) return;
  diagnostics.error(Code::probabilities_exceed_one, join(text.branches.front().span, text.branches.back().span),
                    "the probabilities of these targets sum to " + decimal(sum) + ", expected at most 1");
}

void check_fault_sums(const automata::Plant& type, const std::vector<grammar::Span>& spans,
                      const std::vector<grammar::Span>& modes, grammar::Diagnostics& diagnostics) {
  const automata::Component& component = type.components.front();
  std::vector<std::vector<std::size_t>> faults(component.modes.size());
  for (std::size_t t = 0; t < component.transitions.size(); ++t) {
    const Transition& transition = component.transitions[t];
    if (component.is_fault(transition) && transition.weight.kind == Weight::Kind::probability) {
      faults[transition.from.index()].push_back(t);
    }
  }
  for (std::size_t m = 0; m < faults.size(); ++m) {
    const auto add = [&](double sum, std::size_t t) { return sum + component.transitions[t].weight.value; };
    if (std::accumulate(faults[m].begin(), faults[m].end(), 0.0, add) <= 1 + probability_tolerance) continue;
    const auto found = Overfull(type, automata::ModeId(m), std::move(faults[m])).find();
    if (!found) continue;
    const double sum = std::accumulate(found->begin(), found->end(), 0.0, add);
    auto& error = diagnostics.error(Code::probabilities_exceed_one, spans[found->back()],
                                    "the faults that mode " + backquoted(component.modes[m].name) +
                                        " can take together sum to " + decimal(sum) + ", expected at most 1");
    error.notes.push_back({modes[m], "the mode is declared here"});
    for (std::size_t i = 0; i + 1 < found->size(); ++i) {
      error.notes.push_back({spans[(*found)[i]],
                             "with probability " + decimal(component.transitions[(*found)[i]].weight.value) + " here"});
    }
  }
}

}  // namespace rmpl::compiler
