// The quick scan tells what the library's parser tells, or leaves the text to it.
// SPDX-License-Identifier: MIT
#include "automata/json/scan.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rmpl::automata {
namespace {

/// Writes down what it is told.
class Recorder : public nlohmann::json_sax<Json> {
 public:
  bool null() override { return tell("null"); }
  bool boolean(bool value) override { return tell(value ? "true" : "false"); }
  bool number_integer(std::int64_t value) override { return tell("integer " + Json(value).dump()); }
  bool number_unsigned(std::uint64_t value) override { return tell("unsigned " + Json(value).dump()); }
  bool number_float(double value, const std::string&) override { return tell("float " + Json(value).dump()); }
  bool string(std::string& value) override { return tell("string " + value); }
  bool binary(Json::binary_t&) override { return tell("binary"); }
  bool start_object(std::size_t) override { return tell("{"); }
  bool start_array(std::size_t) override { return tell("["); }
  bool end_object() override { return tell("}"); }
  bool end_array() override { return tell("]"); }
  bool key(std::string& name) override { return tell("key " + name); }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override { return false; }

  std::string told;

 private:
  bool tell(const std::string& what) {
    told += what + "\n";
    return true;
  }
};

/// Whether the scan is sure of a text; if it is, it must be right.
bool scans(std::string_view text) {
  Recorder quick, library;
  if (!scan_json(text, quick)) return false;
  EXPECT_TRUE(Json::sax_parse(text, &library)) << text;
  EXPECT_EQ(quick.told, library.told) << text;
  return true;
}

TEST(JsonScan, IsSureOfPlainTexts) {
  for (const char* text :
       {"{}", "[]", " [ ] ", "0", "-0", "\"\"", "true", "[1, -2, 3.5, -4e-3, 1E+2, 0.0, 18446744073709551615]",
        R"({"a": [{"b": null}, [[], {}], "x"], "c": {"d": false}, "≥ é 🚀": "\\ \" \/ \b\f\n\r\t"})",
        "\t{\r\n\"a\" : 1 ,\n\"b\" : [ true , false ] }\n"}) {
    EXPECT_TRUE(scans(text)) << text;
  }
}

TEST(JsonScan, LeavesTheRestToTheLibrary) {
  for (const std::string text : {"",
                                 " ",
                                 "{",
                                 "[",
                                 "]",
                                 "[1,]",
                                 "{\"a\"}",
                                 "{\"a\":}",
                                 "{\"a\":1,}",
                                 "{,}",
                                 "[,]",
                                 "{1: 2}",
                                 "[1 2]",
                                 "[1}",
                                 "1 2",
                                 "tru",
                                 "truex",
                                 "nul",
                                 "01",
                                 "-",
                                 "-01",
                                 "1.",
                                 ".5",
                                 "1e",
                                 "1e+",
                                 "+1",
                                 "\"",
                                 "\"\\",
                                 "\"\\x\"",
                                 "\"\\u0061\"",
                                 "\"\x1f\"",
                                 "\"\x80\"",
                                 "\"\xe2\x89\"",
                                 "18446744073709551616",
                                 "-9223372036854775809",
                                 "1e999",
                                 "1e-999",
                                 "\xEF\xBB\xBF{}",
                                 "[1] x",
                                 "NaN",
                                 "/**/1"}) {
    EXPECT_FALSE(scans(text)) << text;
  }
  EXPECT_FALSE(scans(std::string_view("[1]\0", 4)));
}

TEST(JsonScan, MutationsOfATextAreReadAlike) {
  const std::string text = R"({"a": [1, -2.5e3, {"b": null, "é": "\\"}], "c": {"d": [true, false, 0.25]}})";
  const std::string signs = "{}[]:,\"\\ 0123456789.eE+-tfn\xc3\xa9\n";
  std::mt19937 random(7);
  int sure = 0;
  for (int i = 0; i < 100'000; ++i) {
    std::string mutated = text;
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      const std::size_t at = random() % mutated.size();
      const char sign = signs[random() % signs.size()];
      switch (random() % 3) {
        case 0:
          mutated[at] = sign;
          break;
        case 1:
          mutated.insert(at, 1, sign);
          break;
        default:
          mutated.erase(at, 1);
      }
    }
    const bool is_sure = scans(mutated);
    sure += is_sure ? 1 : 0;
    if (!is_sure) {
      EXPECT_FALSE(Json::accept(mutated)) << mutated;
    }
  }
  EXPECT_GT(sure, 5'000);
}

}  // namespace
}  // namespace rmpl::automata
