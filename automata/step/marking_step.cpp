// A step of a model program, remembered by marking and command.
// SPDX-License-Identifier: MIT
#include "automata/step/marking_step.hpp"

#include <algorithm>
#include <utility>

#include "base/bounded_cache.hpp"
#include "base/check.hpp"
#include "base/hash.hpp"

namespace rmpl::automata {
namespace {

constexpr std::size_t most_starts = std::size_t{1} << 20;
constexpr std::size_t most_markings = std::size_t{1} << 16;  // that are kept
constexpr std::size_t most_inputs = std::size_t{1} << 8;     // commands, and readings, that are kept

}  // namespace

std::size_t MarkingStep::Hash::operator()(const Marking& marking) const noexcept {
  std::uint64_t hash = base::hash_seed;
  for (const LocationId l : marking) hash = base::mix(hash, l.value);
  return hash;
}

MarkingStep::MarkingStep(const ModelProgram& program, std::size_t most_ways)
    : most_ways_(most_ways), rules_(program), store_(program, rules_.conditions()) {
  command(Command(program.controls.size()));
  observe({});
}

MarkingStep::Number MarkingStep::number(const Marking& primitive) {
  const auto [known, fresh] = numbers_.try_emplace(primitive, static_cast<Number>(markings_.size()));
  if (fresh) markings_.push_back(primitive);
  return known->second;
}

bool MarkingStep::forget_but(const std::vector<Number>& kept) {
  const bool full =
      markings_.size() > most_markings || by_command_.size() > most_inputs || by_observation_.size() > most_inputs;
  if (!full && base::caches_on()) return false;
  std::vector<Marking> stay;
  stay.reserve(kept.size());
  for (const Number number : kept) stay.push_back(std::move(markings_[number]));
  const Command now = *command_;
  const Observation seen = *observation_;
  markings_.clear();
  wholes_.clear();
  values_.clear();
  numbers_.clear();
  possible_.clear();
  by_command_.clear();
  by_observation_.clear();
  command(now);
  observe(seen);
  for (const Marking& marking : stay) number(marking);
  return true;
}

void MarkingStep::command(const Command& command) {
  const auto place = by_command_.try_emplace(command).first;
  command_ = &place->first;
  commanded_ = &place->second;
}

void MarkingStep::observe(const Observation& observation) {
  const auto place = by_observation_.try_emplace(observation).first;
  observation_ = &place->first;
  factors_ = &place->second;
}

template <class Answers>
auto& MarkingStep::slot(Answers& answers, Number marking) {
  if (answers.size() <= marking) answers.resize(markings_.size());
  return answers[marking];
}

const Marking& MarkingStep::whole(Number number) {
  Marking& known = slot(wholes_, number);
  if (known.empty()) known = rules_.whole(markings_[number]);
  return known;
}

const std::vector<Assignment>& MarkingStep::values(Number number) {
  auto& known = slot(values_, number);
  if (!known) known = store_.values(markings_[number]);
  return *known;
}

bool MarkingStep::possible(Number marking) {
  Known& known = slot(possible_, marking);
  if (known == Known::open) known = store_.possible(markings_[marking]) ? Known::yes : Known::no;
  return known == Known::yes;
}

bool MarkingStep::permits(Number marking) {
  Known& known = slot(commanded_->permits, marking);
  if (known == Known::open) known = store_.permits(markings_[marking], *command_) ? Known::yes : Known::no;
  return known == Known::yes;
}

const MarkingMoves& MarkingStep::moves(Number marking) {
  auto& known = slot(commanded_->moves, marking);
  if (!known) {
    const Marking& source = markings_[marking];
    const auto holds = [&](std::size_t condition) { return store_.holds(condition, source, *command_); };
    known = std::make_unique<const MarkingMoves>(rules_.moves(source, holds));
  }
  return *known;
}

const MarkingStep::Ways& MarkingStep::ways(Number marking) {
  if (auto& known = slot(commanded_->ways, marking)) return *known;
  Ways found = permits(marking) ? listed(moves(marking), most_ways_) : Ways(std::in_place);
  auto& known = slot(commanded_->ways, marking);
  known = std::make_unique<const Ways>(std::move(found));
  return *known;
}

MarkingStep::Ways MarkingStep::initial() { return listed(rules_.initial(), most_starts); }

MarkingStep::Ways MarkingStep::listed(const MarkingMoves& moves, std::size_t most) {
  std::size_t size = 1;
  for (const auto& part : moves.parts) {
    size *= part.size();
    if (size > most) return std::nullopt;
  }
  std::vector<std::pair<Marking, double>> all{{moves.certain, 1.0}};
  for (const auto& part : moves.parts) {
    std::vector<std::pair<Marking, double>> longer;
    for (const auto& [marking, probability] : all) {
      for (const MarkingOutcome& outcome : part) {
        Marking both;
        both.reserve(marking.size() + outcome.marked.size());
        std::merge(marking.begin(), marking.end(), outcome.marked.begin(), outcome.marked.end(),
                   std::back_inserter(both));
        longer.emplace_back(std::move(both), probability * outcome.probability);
      }
    }
    all = std::move(longer);
  }
  std::sort(all.begin(), all.end());
  Ways result(std::in_place);
  for (const auto& [marking, probability] : all) {
    const Number target = number(marking);
    if (probability > 0 && possible(target)) result->push_back({target, probability});
  }
  return result;
}

Marking MarkingStep::conflict(Number marking, bool seen) {
  return store_.conflict(markings_[marking], seen ? *observation_ : Observation{});
}

double MarkingStep::factor(Number marking) {
  if (factors_->size() <= marking) factors_->resize(markings_.size(), -1.0);
  double& known = (*factors_)[marking];
  if (known < 0) known = store_.factor(markings_[marking], *observation_);
  return known;
}

}  // namespace rmpl::automata
