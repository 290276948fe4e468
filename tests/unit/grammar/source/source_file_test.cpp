// Lines, columns and encodings.
// SPDX-License-Identifier: MIT
#include "grammar/source/source_file.hpp"

#include <gtest/gtest.h>

#include "grammar/source/diagnostic.hpp"

namespace rmpl::grammar {
namespace {

TEST(SourceFile, CountsLinesFromOneAndColumnsInCodePoints) {
  const SourceFile file("f", "a ≥ b\r\n\nlast");
  EXPECT_EQ(file.line_count(), 3u);
  EXPECT_EQ(file.line(1), "a ≥ b");
  EXPECT_EQ(file.line(2), "");
  EXPECT_EQ(file.line(3), "last");
  EXPECT_EQ(file.place(0), (Place{1, 1}));
  EXPECT_EQ(file.place(6), (Place{1, 5}));  // the b, behind two bytes more than columns
  EXPECT_EQ(file.place(file.line_start(3)), (Place{3, 1}));
  EXPECT_EQ(file.place(static_cast<std::uint32_t>(file.text().size())), (Place{3, 5}));
}

TEST(SourceFile, AnEmptyTextHasOneLine) {
  const SourceFile file("f", "");
  EXPECT_EQ(file.line_count(), 1u);
  EXPECT_EQ(file.line(1), "");
  EXPECT_EQ(file.place(0), (Place{1, 1}));
}

TEST(Encoding, ReportsRunsOfWrongBytesAndNotTooMany) {
  Sources sources;
  Diagnostics diagnostics;
  EXPECT_TRUE(check_encoding(sources, sources.add("good", "≥ fine"), diagnostics));
  std::string bad;
  for (int i = 0; i < 50; ++i) bad += "\xFF\xFF ";
  EXPECT_FALSE(check_encoding(sources, sources.add("bad", bad), diagnostics));
  EXPECT_EQ(diagnostics.all().size(), 10u);
  EXPECT_EQ(diagnostics.all()[1].span, (Span{1, 3, 5}));
}

TEST(SourceFile, ColumnsInUtf16) {
  const SourceFile file("f", "a\nx\xC3\xA9\xF0\x9F\x9A\x80y\r\n");  // é takes one unit, a rocket two
  EXPECT_EQ(file.place(9), (Place{2, 4}));
  EXPECT_EQ(file.place_utf16(9), (Place{2, 5}));
  for (const std::uint32_t offset : {0u, 2u, 3u, 5u, 9u})
    EXPECT_EQ(file.offset_utf16(file.place_utf16(offset)), offset);
  EXPECT_EQ(file.offset_utf16({2, 100}), 10u);
  EXPECT_EQ(file.offset_utf16({9, 1}), 12u);
}

}  // namespace
}  // namespace rmpl::grammar
