// Frames of the protocol, however the bytes come.
// SPDX-License-Identifier: MIT
#include "tools/shared/framing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rmpl::tools {
namespace {

using testing::ElementsAre;

/// What comes out of bytes that come in pieces of one size: messages, and "!" for what is wrong.
std::vector<std::string> read(std::string_view bytes, std::size_t piece) {
  Frames frames;
  std::vector<std::string> found;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    frames.feed(bytes.substr(at, piece));
    while (const auto frame = frames.next()) found.push_back(frame->wrong.empty() ? frame->message : "!");
  }
  return found;
}

TEST(Framing, AMessageComesOutAsItWentIn) {
  EXPECT_EQ(framed("{}"), "Content-Length: 2\r\n\r\n{}");
  EXPECT_THAT(read(framed("{\"a\":\"ä\"}") + framed("{}"), 1000), ElementsAre("{\"a\":\"ä\"}", "{}"));
}

TEST(Framing, OfPiecesOfAnySizeIsTheSame) {
  const std::string bytes =
      framed("{\"one\":1}") + "nonsense\r\n\r\n" + framed("{}") + "Content-Length: 9x\r\n\r\n" + framed("[]");
  const auto whole = read(bytes, bytes.size());
  for (std::size_t piece = 1; piece < bytes.size(); ++piece) EXPECT_EQ(read(bytes, piece), whole) << piece;
}

TEST(Framing, GarbageIsToldOnceAndPassedOver) {
  EXPECT_THAT(read("nonsense\r\n\r\n" + framed("{}"), 1000), ElementsAre("!", "{}"));
}

TEST(Framing, OtherFieldsOfTheHeaderAreTaken) {
  EXPECT_THAT(read("Content-Type: application/vscode-jsonrpc; charset=utf-8\r\ncontent-length: 2\r\n\r\n{}", 1000),
              ElementsAre("{}"));
}

TEST(Framing, AMessageBeyondTheLimitIsAnErrorAndTheNextOneIsRead) {
  const std::string longer(message_limit + 1, ' ');
  EXPECT_THAT(read(framed(longer) + framed("{}"), 1u << 20), ElementsAre("!", "{}"));
}

}  // namespace
}  // namespace rmpl::tools
