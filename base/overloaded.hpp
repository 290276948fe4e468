// One visitor out of several functions, for std::visit.
// SPDX-License-Identifier: MIT
#pragma once

namespace rmpl::base {

template <class... Visits>
struct Overloaded : Visits... {
  using Visits::operator()...;
};
template <class... Visits>
Overloaded(Visits...) -> Overloaded<Visits...>;

}  // namespace rmpl::base
