// Sums of probabilities, by proof where guards decide what applies together.
// SPDX-License-Identifier: MIT
#include "compiler/check/probabilities.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
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
  /// `theory` knows the variables of the type and nothing else; it is asked of many modes, for it is dear to make.
  Overfull(const automata::Component& component, automata::Theory& theory, automata::ModeId mode,
           std::vector<std::size_t> faults)
      : component_(component), theory_(theory), mode_(mode), faults_(std::move(faults)) {
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
    std::vector<Formula> guards{component_.modes[mode_.index()].constraint};
    for (const std::size_t t : taken_) {
      if (!component_.transitions[t].guard.is_true()) guards.push_back(component_.transitions[t].guard);
    }
    return theory_.allows({}, theory_.encode(automata::conjunction(std::move(guards))));
  }

  const automata::Component& component_;
  automata::Theory& theory_;
  const automata::ModeId mode_;
  std::vector<std::size_t> faults_;  ///< positions of transitions, heaviest first
  std::vector<double> rest_;         ///< the sum of the weights from here on
  std::vector<std::size_t> taken_;
  std::size_t patience_ = 1000;
};

bool is_whole(double number) { return number == std::floor(number); }

}  // namespace

std::string decimal(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 6);
  return {buffer.data(), end.ptr};
}

bool check_probability(const grammar::Number& probability, grammar::Diagnostics& diagnostics, const char* whole) {
  if (probability.value >= 0 && probability.value <= 1) return true;
  auto& error = diagnostics.error(Code::probability_out_of_range, probability.span,
                                  "the probability " + probability.text + " is outside [0, 1]");
  if (whole != nullptr && probability.value > 1 && is_whole(probability.value)) error.suggestion = whole;
  return false;
}

std::optional<std::vector<double>> probabilities_of(const std::vector<const grammar::Number*>& numbers,
                                                    grammar::Span list, Code below, const std::string& of,
                                                    grammar::Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  const bool weights = std::any_of(numbers.begin(), numbers.end(), [](const grammar::Number* number) {
    return number->value > 1 && is_whole(number->value);
  });
  std::vector<double> result;
  for (const grammar::Number* number : numbers) {
    result.push_back(number->value);
    if (!weights) check_probability(*number, diagnostics);
    if (weights && number->value < 0) {
      diagnostics.error(Code::probability_out_of_range, number->span, "the weight " + number->text + " is below 0");
    }
  }
  if (diagnostics.error_count() != errors) return std::nullopt;
  const double sum = std::accumulate(result.begin(), result.end(), 0.0);
  if (weights) {
    for (double& share : result) share /= sum;
    return result;
  }
  if (std::abs(sum - 1) <= probability_tolerance) return result;
  auto& error = diagnostics.error(sum > 1 ? Code::probabilities_exceed_one : below, list,
                                  "the " + of + " probabilities sum to " + decimal(sum) + ", expected 1");
  const bool whole = std::all_of(result.begin(), result.end(), is_whole);
  error.suggestion = whole && sum > 1 ? "equal shares are told from probabilities by numbers above 1: `2` and `2`"
                                      : "shares are written as whole numbers: `3` and `1` for 3 of 4 and 1 of 4";
  return std::nullopt;
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
  std::optional<automata::Theory> theory;
  for (std::size_t m = 0; m < faults.size(); ++m) {
    const auto add = [&](double sum, std::size_t t) { return sum + component.transitions[t].weight.value; };
    if (std::accumulate(faults[m].begin(), faults[m].end(), 0.0, add) <= 1 + probability_tolerance) continue;
    if (!theory) theory.emplace(type.variables);
    const auto found = Overfull(component, *theory, automata::ModeId(m), std::move(faults[m])).find();
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
