// Reading and writing files: whole or with the reason why not, links followed, modes kept, inputs spared.
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/rewrite_file.hpp"

namespace rmpl::base {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

class Files : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(directory_); }
  void TearDown() override { fs::remove_all(directory_); }
  [[nodiscard]] std::string path(const std::string& name) const { return (directory_ / name).string(); }
  std::string make(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  static std::string text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static mode_t mode(const std::string& path) {
    struct stat about = {};
    EXPECT_EQ(stat(path.c_str(), &about), 0);
    return about.st_mode & 07777;
  }
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory_), {}));
  }

 private:
  fs::path directory_ = fs::path(testing::TempDir()) / ("rmpl-files-test-" + std::to_string(::getpid()));
};

TEST_F(Files, LongerThanTheLimitAreRefused) {
  const std::string lines = make("lines", std::string(100, 'x') + "\n" + std::string(100, 'y'));
  limit_inputs(201);
  EXPECT_EQ(read_file(lines).size(), 201u);
  limit_inputs(200);
  EXPECT_THAT([&] { (void)read_file(lines); }, ThrowsMessage<InputError>(HasSubstr("a text of more than 200 bytes")));
  const std::string line = make("line", std::string(100'000, 'z'));
  InputFile file(lines);
  InputFile endless(line);
  std::string text;
  EXPECT_TRUE(std::getline(file.stream(), text));
  EXPECT_THAT([&] { std::getline(endless.stream(), text); },
              ThrowsMessage<InputError>(HasSubstr("a line of more than 200 bytes")));
  limit_inputs(std::size_t{1} << 30);
}

TEST_F(Files, RegularOnesAreReadWithoutWaiting) {
  const std::string text = make("text", "some text");
  EXPECT_EQ(read_regular_file(text, 9), "some text");
  EXPECT_THAT([&] { (void)read_regular_file(text, 8); },
              ThrowsMessage<InputError>(HasSubstr("a text of more than 8 bytes")));
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  for (const std::string& other : {path("pipe"), std::string("/dev/zero"), std::string("/dev/null")}) {
    EXPECT_THAT([&] { (void)read_regular_file(other, 100); },
                ThrowsMessage<InputError>(HasSubstr("is no regular file")));
  }
  EXPECT_THAT([&] { (void)read_regular_file(path(""), 100); }, ThrowsMessage<InputError>(HasSubstr("is a directory")));
  fs::create_symlink(text, path("link"));
  EXPECT_EQ(read_regular_file(path("link"), 100), "some text");
}

TEST_F(Files, AreReadWhole) {
  std::string big(200'000, 'x');
  big += std::string("\0\r\n", 3);
  EXPECT_EQ(read_file(make("big", big)), big);
  EXPECT_EQ(read_file(make("empty", "")), "");
  InputFile file(path("big"));
  std::string line;
  EXPECT_TRUE(std::getline(file.stream(), line));
  EXPECT_EQ(line.size(), 200'002u);
  EXPECT_FALSE(std::getline(file.stream(), line));
}

TEST_F(Files, WhatCannotBeReadSaysWhy) {
  EXPECT_THAT([&] { (void)read_file(path("none")); },
              ThrowsMessage<InputError>(HasSubstr("No such file or directory")));
  EXPECT_THAT([&] { (void)read_file(path("")); },
              ThrowsMessage<InputError>(HasSubstr("is a directory, expected a file")));
  EXPECT_THAT([&] { (void)read_file(""); }, ThrowsMessage<InputError>("'' is no name of a file"));
  // Its first page cannot be read by anyone: an error in the middle of a read, not when it is opened.
  InputFile memory("/proc/self/mem");
  std::string line;
  EXPECT_THAT([&] { std::getline(memory.stream(), line); }, ThrowsMessage<InputError>(HasSubstr("Input/output error")));
}

TEST_F(Files, AreReplacedAsAWholeAndKeepTheirMode) {
  const std::string out = make("out", "before");
  fs::permissions(out, fs::perms::owner_read | fs::perms::owner_write);
  {
    OutputFile file(out);
    file.write("after");
    EXPECT_EQ(text(out), "before");
  }
  EXPECT_EQ(text(out), "before") << "what is not kept changes nothing";
  write_file(out, "after");
  EXPECT_EQ(text(out), "after");
  EXPECT_EQ(mode(out), 0600u);
  write_file(path("new"), std::string(200'000, 'x'));
  EXPECT_EQ(text(path("new")).size(), 200'000u);
  EXPECT_EQ(mode(path("new")) & 0600u, 0600u);
  EXPECT_EQ(count(), 2u) << "no temporary file is left";
}

TEST_F(Files, LinksAreFollowed) {
  make("real", "before");
  fs::create_symlink("real", path("link"));
  fs::create_symlink("later", path("dangling"));
  write_file(path("link"), "after");
  write_file(path("dangling"), "new");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_TRUE(fs::is_symlink(path("dangling")));
  EXPECT_EQ(text(path("real")), "after");
  EXPECT_EQ(text(path("later")), "new");
}

TEST_F(Files, WhatIsNoRegularFileIsWrittenInPlace) {
  write_file("/dev/null", "nothing");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  ASSERT_EQ(mkfifo(path("fifo").c_str(), 0600), 0);
  auto reader = std::async(std::launch::async, [&] { return text(path("fifo")); });
  write_file(path("fifo"), "through");
  EXPECT_EQ(reader.get(), "through");
  EXPECT_TRUE(fs::is_fifo(path("fifo")));
  EXPECT_THAT([] { write_file("/dev/full", "x"); },
              ThrowsMessage<InputError>("/dev/full: cannot be written: No space left on device"));
}

TEST_F(Files, WhatCannotBeWrittenSaysWhy) {
  EXPECT_THAT([&] { OutputFile file(path("")); }, ThrowsMessage<InputError>(HasSubstr("is a directory")));
  EXPECT_THAT([&] { OutputFile file(make("file", "x") + "/below"); },
              ThrowsMessage<InputError>(HasSubstr("Not a directory")));
  EXPECT_THAT([&] { OutputFile file(path("none/below")); }, ThrowsMessage<InputError>(HasSubstr("No such file")));
  EXPECT_THAT([] { OutputFile file(""); }, ThrowsMessage<InputError>("'' is no name of a file"));
}

TEST_F(Files, WhatWasReadIsNeverOverwritten) {
  const std::string in = make("in", "input");
  fs::create_symlink("in", path("link"));
  fs::create_hard_link(in, path("twin"));
  EXPECT_EQ(input_at(in), std::nullopt);
  (void)read_file(in);
  for (const char* name : {"in", "link", "twin"}) {
    EXPECT_THAT([&] { OutputFile file(path(name)); }, ThrowsMessage<InputError>(HasSubstr("would destroy the input")));
  }
  EXPECT_EQ(text(in), "input");
  rewrite_file(path("link"), "what was made of it");
  EXPECT_EQ(text(in), "what was made of it");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  (void)read_file(in);
  fs::remove(path("twin"));
  fs::remove(in);
  write_file(in, "what was read is gone, so its name is free");
}

TEST_F(Files, UnfinishedOnesCanBeRemovedByASignalHandler) {
  OutputFile file(path("out"));
  EXPECT_EQ(count(), 1u);
  remove_unfinished_files();
  EXPECT_EQ(count(), 0u);
}

}  // namespace
}  // namespace rmpl::base
