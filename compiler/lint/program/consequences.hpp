// What a construct does where its condition never holds, and where it always does; for messages.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace rmpl::compiler {

struct Consequences {
  const char* never;
  const char* always;
};

/// `instant`: of a model program, where what is inside of a condition is told once before it is left (semantics 8).
inline Consequences consequences_of(std::string_view construct, bool instant = false) {
  constexpr const char* once = "what is inside lasts for one instant";
  if (instant && construct == "watching") return {"nothing is watched for", once};
  if (instant && construct == "maintaining") return {once, "nothing is maintained"};
  if (instant && construct == "whenever") return {"what follows never runs", "what follows runs in every instant"};
  if (construct == "watching") return {"nothing is watched for", "what is inside never runs"};
  if (construct == "maintaining") return {"what is inside never runs", "nothing is maintained"};
  if (construct == "when") return {"the wait never ends", "there is no wait"};
  if (construct == "whenever") return {"what follows never runs", "what follows runs in every cycle"};
  if (construct == "unless") return {"what follows always runs", "what follows never runs"};
  return {"what follows `thennext` never runs", "what follows `elsenext` never runs"};
}

}  // namespace rmpl::compiler
