// Flights for the tools of others: wave viewers, spreadsheets, robotics.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "runtime/report/flight.hpp"

namespace rmpl::runtime {

/// A value change dump (IEEE 1364-2005, clause 18) in nanoseconds. A scope for each component, with its mode as
/// estimated and in truth and the goal for it as Verilog strings (eight bits a character), the share of the belief in
/// percent as a real, and whether a fault is estimated as a bit; in scopes within it, its commands and readings; a
/// scope with the channels of telemetry, those of numbers as reals; one with a bit for each location of the program.
/// What nobody knows is `x`, what nobody asks for `z`.
std::string to_vcd(const Flight& flight);

/// Comma-separated values (RFC 4180): a line for each change, with the columns time (seconds), kind, name, value and
/// note. Kinds: estimate, truth, belief (value in percent), goal, command, sample (name of the channel), reading,
/// marking, event, verdict.
std::string to_csv(const Flight& flight);

/// MCAP, uncompressed, in indexed chunks: JSON messages with schemas on `/estimate`, `/truth`,
/// `/belief`, `/goal`, `/command`, `/reading`, `/marking` and `/event`, and on `/channel` where there was telemetry;
/// each has all that holds from its time on. Log time is nanoseconds since the start of the flight.
std::string to_mcap(const Flight& flight);

}  // namespace rmpl::runtime
