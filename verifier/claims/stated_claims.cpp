// Claims in the order of the file; what is asked along with them at its end.
// SPDX-License-Identifier: MIT
#include "verifier/claims/stated_claims.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "automata/assignment_text.hpp"
#include "verifier/claims/probability_claim.hpp"
#include "verifier/claims/stated_property.hpp"

namespace rmpl::verifier {

using automata::PlantProperty;

namespace {

Commands commands_of(PlantProperty::Commands commands) {
  switch (commands) {
    case PlantProperty::Commands::none:
      return Commands::none;
    case PlantProperty::Commands::one:
      return Commands::one;
    case PlantProperty::Commands::any:
      return Commands::any;
  }
  return Commands::one;
}

/// Along with claims on a program it is asked whether a run of it gets stuck, once for all that leave the same things
/// free, unless a property claims just that.
void ask_for_stuck_runs(std::vector<PlantProperty>& stated, const automata::Plant& plant) {
  const auto free = [](const PlantProperty& p) { return std::tie(p.period, p.faults, p.from); };
  std::vector<PlantProperty> asked;
  for (const PlantProperty& p : stated) {
    if (!p.of_program || p.allow_stuck || is_measured(p)) continue;
    const auto covers = [&](const PlantProperty& other) {
      return other.of_program && other.claim == PlantProperty::Claim::stuck && free(other) == free(p);
    };
    const auto known = [&](const std::vector<PlantProperty>& some) {
      return std::any_of(some.begin(), some.end(), covers);
    };
    if (known(stated) || known(asked)) continue;
    PlantProperty stuck;
    stuck.claim = PlantProperty::Claim::stuck;
    stuck.of_program = true;
    stuck.origin.file = p.origin.file;  // on no line of it
    std::tie(stuck.period, stuck.faults, stuck.from) = free(p);
    asked.push_back(std::move(stuck));
  }
  for (PlantProperty& stuck : asked) {
    stuck.name = "program never stuck";
    if (asked.size() == 1) continue;
    stuck.name += stuck.period ? ", time " + automata::format_seconds(*stuck.period) + " s" : ", time dense";
    stuck.name += ", faults " + std::to_string(stuck.faults);
    if (!stuck.from.empty()) stuck.name += ", from " + automata::to_text(plant.variables, stuck.from);
  }
  std::move(asked.begin(), asked.end(), std::back_inserter(stated));
}

CheckOptions freedom_of(const PlantProperty& p) {
  CheckOptions free{.period = p.period,
                    .faults = p.faults,
                    .commands = commands_of(p.commands),
                    .entailed = p.entailed,
                    .from = p.from};
  if (is_measured(p) && !p.faults_stated) free.faults.reset();
  return free;
}

}  // namespace

bool is_measured(const PlantProperty& property) { return property.claim == PlantProperty::Claim::probability; }

StatedClaims::StatedClaims(const Subject& subject, std::vector<PlantProperty> stated, const Bounds& bounds)
    : subject_(subject), stated_(std::move(stated)), bounds_(bounds) {
  ask_for_stuck_runs(stated_, subject.plant);
  for (const PlantProperty& p : stated_) {
    if (!is_measured(p)) questions_.push_back({property_of(p, subject.plant), freedom_of(p), bounds});
  }
}

std::vector<Claim> StatedClaims::with(std::vector<Answer> answers, const Limits& limits) const {
  std::vector<Claim> claims;
  std::size_t q = 0;
  for (const PlantProperty& p : stated_) {
    if (is_measured(p)) {
      claims.push_back(check_probability(subject_, p, freedom_of(p), bounds_, limits));
    } else {
      claims.push_back({.name = p.name,
                        .origin = p.origin,
                        .question = questions_[q],
                        .expect_violated = p.expect_violated,
                        .answer = std::move(answers[q])});
      ++q;
    }
    claims.back().hazard = p.hazard;
    claims.back().severity = p.severity;
    claims.back().requirements = p.requirements;
  }
  return claims;
}

}  // namespace rmpl::verifier
