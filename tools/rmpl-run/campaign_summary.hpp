// What a campaign found: tables with intervals, as text, as CSV and as a page.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/painter.hpp"
#include "runtime/executive/campaign/flight.hpp"

namespace rmpl::tools {

/// Counts of some runs, and of the faults that were injected in them.
struct CampaignTally {
  std::uint64_t runs = 0, met = 0, finished = 0, undecided = 0,
                impossible = 0;  ///< of a fault: runs in which it was injected
  std::uint64_t cycles = 0, right = 0, by_chance = 0;
  std::uint64_t drawn = 0;     ///< faults that were to happen
  std::uint64_t injected = 0;  ///< of them, those that did
  std::uint64_t shown = 0;     ///< of those, the ones with a symptom
  std::uint64_t named = 0;     ///< of those, the ones named no later than ten seconds after it
  std::vector<automata::Ticks>
      latencies;  ///< from symptom to name, of all that have both; below 0 where it was named first

  void add_run(const runtime::CampaignRun& run);
  void add_fault(const runtime::Injected& injected);
};

/// All runs of a campaign, added one by one.
class CampaignSummary {
 public:
  explicit CampaignSummary(const automata::Plant& plant) : plant_(plant) {}
  void add(const runtime::CampaignRun& run);

  [[nodiscard]] std::uint64_t runs() const { return all_.runs; }
  /// Runs that did not meet what is expected, but for those that are impossible for the model: they say nothing.
  [[nodiscard]] std::uint64_t failed() const { return all_.runs - all_.met - all_.impossible; }

  /// `heading` is a line that says what was flown.
  [[nodiscard]] std::string text(const std::string& heading, base::Painter painter) const;
  /// One HTML file that needs no other.
  [[nodiscard]] std::string page(const std::string& heading) const;

 private:
  using Row = std::vector<std::string>;
  [[nodiscard]] std::vector<Row> totals() const;
  [[nodiscard]] std::vector<Row> by_component() const;
  [[nodiscard]] std::vector<Row> by_fault() const;
  [[nodiscard]] std::vector<Row> failures() const;
  [[nodiscard]] std::string name_of(std::pair<std::size_t, std::size_t> fault) const;

  const automata::Plant& plant_;
  CampaignTally all_;
  std::vector<runtime::CampaignRun> failed_;  ///< the first few hundred
  std::map<std::size_t, CampaignTally> components_;
  std::map<std::pair<std::size_t, std::size_t>, CampaignTally> faults_;  ///< component and mode
};

}  // namespace rmpl::tools
