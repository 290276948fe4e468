// The modes of a thread: one for each marking, and others by which it is seen that an improbable draw led there.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "automata/plant.hpp"
#include "automata/software/threads.hpp"

namespace rmpl::automata {

/// A step is a fault if it takes an improbable draw, and the modes before and after a step tell whether it is one. So a
/// marking has
/// - a mode that likely draws lead to; if each way to the marking takes an improbable draw, this one is a fault mode,
///   to which improbable draws lead as well;
/// - a fault mode for the improbable draws that need another one: the marking is a likely one, or it is left for
/// itself,
///   or a likely draw leads from the same marking to it under other conditions;
/// - one more, if an improbable draw leads from the marking to itself: it has led there twice in a row.
class MarkingModes {
 public:
  /// `thread`: with the steps that it has; markings without a way there have no modes.
  explicit MarkingModes(const Thread& thread);

  struct Of {
    std::size_t marking;
    std::optional<ModeId> usual;  ///< the first mode of the marking; this one is another
  };
  /// Those of the first kind come first.
  [[nodiscard]] const std::vector<Of>& all() const { return all_; }
  /// All modes of a marking, ascending.
  [[nodiscard]] const std::vector<ModeId>& of(std::size_t marking) const { return of_[marking]; }
  /// The mode that an outcome of a step out of a mode leads to.
  [[nodiscard]] ModeId after(ModeId from, const ThreadOutcome& outcome) const;

 private:
  /// Whether an improbable draw from one marking needs a mode of its own in another.
  [[nodiscard]] bool apart(std::size_t from, std::size_t to) const;
  [[nodiscard]] bool leads(std::size_t from, std::size_t to, bool improbable) const;

  const Thread& thread_;
  std::vector<Of> all_;
  std::vector<std::vector<ModeId>> of_;
};

}  // namespace rmpl::automata
