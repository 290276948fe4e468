// File URIs and paths.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/uri.hpp"

#include <gtest/gtest.h>

namespace rmpl::tools {
namespace {

TEST(Uri, GoesThereAndBack) {
  for (const char* path : {"/a/b.rmpl", "/with space/50%.tcca", "/ö/ü.scn", "/a#b?c"}) {
    EXPECT_EQ(path_of_uri(uri_of_path(path)), path);
  }
}

TEST(Uri, OfAPathIsPercentEncoded) { EXPECT_EQ(uri_of_path("/a b/ö"), "file:///a%20b/%C3%B6"); }

TEST(Uri, AHostMayBeEmptyOrThisOne) {
  EXPECT_EQ(path_of_uri("file:///a"), "/a");
  EXPECT_EQ(path_of_uri("file://localhost/a"), "/a");
}

TEST(Uri, WhatIsNoFileHereIsNone) {
  EXPECT_EQ(path_of_uri("https://a/b"), std::nullopt);
  EXPECT_EQ(path_of_uri("file://elsewhere/a"), std::nullopt);
  EXPECT_EQ(path_of_uri("file:///a%00b"), std::nullopt);
  EXPECT_EQ(path_of_uri("untitled:Untitled-1"), std::nullopt);
}

}  // namespace
}  // namespace rmpl::tools
