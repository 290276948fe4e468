// Whatever a file is called, its name can stand in XML.
// SPDX-License-Identifier: MIT
#include "base/xml_text.hpp"

#include <gtest/gtest.h>

namespace rmpl::base {
namespace {

TEST(XmlText, KeepsWhatXmlCanHold) {
  const std::string fine = "a\nb <&> \u00e9 \u20ac \U0001f680";
  EXPECT_EQ(xml_text(fine), fine);
  EXPECT_EQ(xml_text("a\x01\x1b\tb"), "a\\x01\\x1b\\x09b");
}

TEST(XmlText, WritesBytesThatAreNoCharacterByTheirNumbers) {
  EXPECT_EQ(xml_text("\xff"), "\\xff");
  EXPECT_EQ(xml_text("\xc3"), "\\xc3");                             // ends too soon
  EXPECT_EQ(xml_text("\xc0\x80"), "\\xc0\\x80");                    // longer than need be
  EXPECT_EQ(xml_text("\xe0\x80\x80"), "\\xe0\\x80\\x80");           // likewise
  EXPECT_EQ(xml_text("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // a surrogate
  EXPECT_EQ(xml_text("\xef\xbf\xbe"), "\\xef\\xbf\\xbe");           // no character of XML
  EXPECT_EQ(xml_text("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond Unicode
}

}  // namespace
}  // namespace rmpl::base
