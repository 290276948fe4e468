// The threads that fly a campaign, among however many processes.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "automata/json/document.hpp"
#include "runtime/executive/campaign/flight.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "tools/rmpl-run/campaign_store.hpp"

namespace rmpl::tools {

/// What is the same in all runs.
struct Campaign {
  const automata::Document& document;
  const automata::Scenario& scenario;
  runtime::CampaignPlan plan;
  std::uint64_t runs = 0;
  runtime::ScenarioOptions flight;
  std::map<std::string, std::string> identity;

  [[nodiscard]] const automata::Plant& plant() const { return document.plants[scenario.plant]; }
};

/// Flies the runs of a campaign that no other thread or process flies.
class CampaignCrew {
 public:
  /// `jobs`: threads, at least one. `tells`: shows progress. Keeps a reference to the campaign.
  CampaignCrew(const Campaign& campaign, std::string database, unsigned jobs, bool tells)
      : campaign_(campaign), database_(std::move(database)), jobs_(jobs), tells_(tells) {}

  /// Returns once every run has its result, or at an interruption; false then. Throws what a thread threw.
  bool work();

 private:
  [[nodiscard]] bool ends() const;
  void one();
  /// Looks at every run that is not known to be done, and flies those that nobody else does. Whether there was one.
  bool pass(CampaignStore& store, CampaignClaims& claims, std::vector<bool>& done);
  void tell_progress(CampaignStore& store);
  /// `120 of 1000 runs, 14.2 a second, 62 s left, 3 failed`.
  std::string progress(CampaignStore& store, std::chrono::steady_clock::time_point now);

  const Campaign& campaign_;
  std::string database_;
  unsigned jobs_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::optional<std::uint64_t> before_;  ///< results that were there at the start
  bool tells_;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace rmpl::tools
