// A file that grows while something goes on: what is written can be read at once, and stays whatever ends the process.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace rmpl::base {

/// Is opened by the first `append`, which takes what stood there away: who writes nothing leaves the file as it was.
class JournalFile {
 public:
  /// Throws InputError where the name is none, or that of a file that was read.
  explicit JournalFile(std::string path);
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  /// Hands the text to the system before it returns. Throws InputError with the reason where it cannot be written.
  void append(std::string_view text);

 private:
  [[noreturn]] void fail(int reason) const;

  std::string path_;
  int file_ = -1;
};

}  // namespace rmpl::base
