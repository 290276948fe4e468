// The mode at the end of the cycle is the forced one.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/forced.hpp"

namespace rmpl::runtime {

bool is_forced_as_nominal(const Event& event, const CycleRecord& record, const automata::Plant& plant) {
  if (event.kind != Event::Kind::forced || !event.component || record.truth == nullptr) return false;
  return !plant[*event.component].modes[(*record.truth)[event.component->index()].index()].fault;
}

}  // namespace rmpl::runtime
