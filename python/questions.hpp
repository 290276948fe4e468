// Questions to a model, each with its answer as JSON: what the programs print.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "python/model.hpp"

namespace rmpl::python {

/// `from` holds assignments, `goal` a constraint; `cycle` is a duration, empty: dense time.
std::string plan(const ModelPointer& model, const std::string& from, const std::string& goal, bool one_step,
                 const std::string& cycle);

std::string diagnose(const ModelPointer& model, const std::string& observe, const std::string& modes, std::size_t k,
                     double ratio, bool all_minimal, bool first, bool count);

struct Budget {
  std::optional<std::size_t> states;
  std::optional<automata::Ticks> time;
  std::optional<std::size_t> bytes;
};

/// `properties` is a path; `text`, where there is one, lies over the disk there. `only`: names; empty: all.
std::string check(const ModelPointer& model, const std::string& properties, const std::optional<std::string>& text,
                  const std::vector<std::string>& only, const Budget& budget);

/// JSON: an array with a row a run.
std::string campaign(const ModelPointer& model, const std::optional<std::string>& scenario, std::uint64_t runs,
                     std::uint64_t faults, std::uint64_t seed, unsigned jobs, bool unmodelled);

}  // namespace rmpl::python
