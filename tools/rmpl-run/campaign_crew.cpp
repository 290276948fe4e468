// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/campaign_crew.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <thread>

#include "base/work_together.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/progress.hpp"

namespace rmpl::tools {

bool CampaignCrew::work() {
  const std::uint64_t jobs = std::min<std::uint64_t>(jobs_, std::max<std::uint64_t>(campaign_.runs, 1));
  base::work_together(jobs, [this] { one(); });
  return !interrupted();
}

bool CampaignCrew::ends() const { return stop_ || interrupted(); }

void CampaignCrew::one() {
  try {
    CampaignStore store(database_, campaign_.plant(), campaign_.identity);
    CampaignClaims claims(database_);
    std::vector<bool> done(campaign_.runs);
    while (!ends() && store.count(campaign_.runs) < campaign_.runs) {
      if (pass(store, claims, done)) continue;
      // All that is left is claimed by others, who may still die.
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  } catch (...) {
    stop_ = true;
    throw;
  }
}

bool CampaignCrew::pass(CampaignStore& store, CampaignClaims& claims, std::vector<bool>& done) {
  bool some = false;
  for (std::uint64_t run = 0; run < campaign_.runs && !ends(); ++run) {
    // Asked before it is claimed, for it may be done long since, and again after, for it may have been done in
    // between.
    if (!done[run]) done[run] = store.has(run);
    if (done[run] || !claims.claim(run)) continue;
    if (!store.has(run)) {
      some = true;
      const auto result =
          runtime::fly_run(campaign_.document, campaign_.scenario, campaign_.plan, run, campaign_.flight);
      if (result) store.add(*result);
      tell_progress(store);
    }
    claims.release(run);
  }
  return some;
}

void CampaignCrew::tell_progress(CampaignStore& store) {
  if (!tells_) return;
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(500);
  show_progress(progress(store, now));
}

std::string CampaignCrew::progress(CampaignStore& store, std::chrono::steady_clock::time_point now) {
  const std::uint64_t done = store.count(campaign_.runs);
  if (!before_) before_ = done - std::min<std::uint64_t>(done, 1);  // runs of an earlier start take no time
  std::string text = std::to_string(done) + " of " + std::to_string(campaign_.runs) + " runs";
  const double seconds = std::chrono::duration<double>(now - start_).count();
  if (done > *before_ && seconds > 0) {
    const double rate = static_cast<double>(done - *before_) / seconds;
    char told[64];
    std::snprintf(told, sizeof told, ", %.3g a second, %.0f s left", rate,
                  std::ceil(static_cast<double>(campaign_.runs - done) / rate));
    text += told;
  }
  return text + ", " + std::to_string(store.count_failed(campaign_.runs)) + " failed";
}

}  // namespace rmpl::tools
