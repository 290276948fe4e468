// Verdicts in words.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "verifier/verdict/answer.hpp"
#include "verifier/verdict/subject.hpp"

namespace rmpl::verifier {

/// `EntrySequence on MarsLander`; of a plant alone its name.
std::string title(const Subject& subject);
/// `holds`, `violated`, `undecided`.
std::string_view to_text(Verdict verdict);
/// The verdict, in its colour if asked for; one that only warns is not red.
std::string painted(Verdict verdict, bool color, bool warning = false);

/// Why a search found no answer, or perhaps not the best, and how far it got; empty where no limit was hit.
std::string reason(std::optional<Limit> limit, const Progress& progress);
/// The same of an answer.
std::string reason(const Answer& answer);

/// Why nothing could ever violate the property, where that is so.
std::string vacuity(const Answer& answer);
/// What an answer means: "the target is reachable", "every goal has a plan".
std::string meaning(const Property& property, const Answer& answer);
/// Which of the runs that a verdict without a witness speaks of it does not follow to the end; empty where it does.
std::string partly(const Answer& answer);
/// For a report of tests, which has but a word for what is as it should be: that nothing could violate what holds, or
/// up to where runs were looked at, and what is warned of; lines ended.
std::string notes(const Answer& answer);
/// What a program's run has come to where it violates the property: the goals, the reason, the locations that wait.
std::string finding(const Subject& subject, const ProgramProperty& property, const Witness& witness);

/// A probability or an importance, with nine digits.
std::string number_text(double value);

/// `12 states, 0.003 s, 6.5 MiB`.
std::string statistics_text(const Progress& progress);

}  // namespace rmpl::verifier
