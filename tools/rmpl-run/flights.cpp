// Each flight is a task; what they tell comes in their order.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/flights.hpp"

#include <optional>

#include "base/work_together.hpp"
#include "tools/shared/interruption.hpp"

namespace rmpl::tools {

std::vector<std::optional<Flown>> fly_all(const std::vector<Task>& tasks, const FlightOptions& options,
                                          const Common& common) {
  InTurn voices(tasks.size());
  std::vector<std::optional<Flown>> flown(tasks.size());
  base::share_tasks(options.jobs, tasks.size(), [&](std::size_t task, std::size_t) {
    if (interrupted()) return;
    flown[task] = fly(tasks[task], options, common, voices, task, tasks.size());
    // One that is interrupted keeps the word: no other flight is told.
    if (!flown[task]->result.interrupted) voices.done(task);
  });
  return flown;
}

}  // namespace rmpl::tools
