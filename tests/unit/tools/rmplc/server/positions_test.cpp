// Places in UTF-16 units and bytes.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/positions.hpp"

#include <gtest/gtest.h>

namespace rmpl::tools {
namespace {

// a, ä (two bytes, one unit), 𝄞 (four bytes, two units), line end, b
const grammar::SourceFile source("a.rmpl", "aä𝄞\nb");

Json at(std::uint32_t line, std::uint32_t character) { return {{"line", line}, {"character", character}}; }

TEST(Positions, CountUnitsNotBytes) {
  EXPECT_EQ(position_of(source, 0), at(0, 0));
  EXPECT_EQ(position_of(source, 1), at(0, 1));
  EXPECT_EQ(position_of(source, 3), at(0, 2));
  EXPECT_EQ(position_of(source, 7), at(0, 4));
  EXPECT_EQ(position_of(source, 8), at(1, 0));
}

TEST(Positions, GoThereAndBack) {
  for (const std::uint32_t offset : {0u, 1u, 3u, 7u, 8u, 9u})
    EXPECT_EQ(offset_of(source, position_of(source, offset)), offset);
}

TEST(Positions, BeyondALineOrTheTextAreItsEnd) {
  EXPECT_EQ(offset_of(source, at(0, 99)), 7u);
  EXPECT_EQ(offset_of(source, at(9, 0)), 9u);
}

}  // namespace
}  // namespace rmpl::tools
