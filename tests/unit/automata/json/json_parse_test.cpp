// Keys that stand twice are refused, and every value is found again in its text.
// SPDX-License-Identifier: MIT
#include "automata/json/parse.hpp"

#include <gtest/gtest.h>

namespace rmpl::automata {
namespace {

using Blame = JsonError::Blame;

std::string found(std::string_view text, std::string_view path, Blame blame = Blame::value) {
  const JsonPlace place = place_of(text, path, blame);
  return std::string(text.substr(place.begin, place.end - place.begin));
}

TEST(JsonParse, RefusesAKeyThatStandsTwice) {
  const std::string text = R"({"a": [{}, {"b/c": 1, "d": {"b/c": 2}, "b/c": 3}], "b/c": 4})";
  try {
    parse_json(text);
    FAIL();
  } catch (const JsonError& error) {
    EXPECT_STREQ(error.what(), "/a/1/b~1c: the key 'b/c' stands twice in one object");
    EXPECT_EQ(place_of(text, error.path(), error.blame()).begin, text.find("\"b/c\": 3"));
  }
  EXPECT_EQ(parse_json(R"({"a": {"a": [{"a": 1}, {"a": 2}]}})").size(), 1U);
}

TEST(JsonParse, KeysThatStandTwiceWithinOneThatDoes) {
  try {
    parse_json(R"({"a": 1, "a": {"b": [1], "b": {"c": [2, 3], "c": {"d": 4}}, "e": [5, {"f": 6}]}, "g": 7})");
    FAIL();
  } catch (const JsonError& error) {
    EXPECT_STREQ(error.what(), "/a: the key 'a' stands twice in one object");
  }
}

TEST(JsonParse, ASyntaxErrorComesFirst) { EXPECT_THROW(parse_json(R"({"a": 1, "a": 2)"), Json::parse_error); }

TEST(JsonParse, EscapedSpellingsOfOneKeyAreTheSame) { EXPECT_THROW(parse_json(R"({"a": 1, "\u0061": 2})"), JsonError); }

TEST(JsonParse, AnObjectOfVeryManyKeysIsRefusedSoon) {
  std::string text = "{\"a\": {\"k\": 0";
  for (int i = 0; i < 1'100'000; ++i) text += ", \"k" + std::to_string(i) + "\": 0";
  try {
    parse_json(text + "}}");
    FAIL();
  } catch (const JsonError& error) {
    EXPECT_EQ(error.path(), "/a");
  }
}

TEST(JsonPlace, AByteOrderMarkIsSkipped) { EXPECT_EQ(found("\xEF\xBB\xBF{\"a\": 1}", "/a"), "1"); }

TEST(JsonPlace, FindsValuesAndKeys) {
  const std::string text = " {\"a\" : [ 1,\n[] , {\"~/\": \"x\\\"}\" , \"e\":{}} ,-2.5e3] , \"b\":true} ";
  EXPECT_EQ(found(text, ""), "{");
  EXPECT_EQ(found(text, "/a"), "[");
  EXPECT_EQ(found(text, "/a", Blame::key), "\"a\"");
  EXPECT_EQ(found(text, "/a/0"), "1");
  EXPECT_EQ(found(text, "/a/1"), "[");
  EXPECT_EQ(found(text, "/a/2/~0~1"), "\"x\\\"}\"");
  EXPECT_EQ(found(text, "/a/2/e", Blame::key), "\"e\"");
  EXPECT_EQ(found(text, "/a/3"), "-2.5e3");
  EXPECT_EQ(found(text, "/b"), "true");
}

TEST(JsonPlace, APathThatLeadsNowhereEndsWhereItLeadsFurthest) {
  const std::string text = R"({"a": [1, 2]})";
  EXPECT_EQ(found(text, "/a/7/x"), "[");
  EXPECT_EQ(found(text, "/b", Blame::key), "{");
  EXPECT_EQ(found("3", "/b", Blame::key), "3");
}

}  // namespace
}  // namespace rmpl::automata
