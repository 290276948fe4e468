// What several flights at once have to say, told in the order of the flights.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace rmpl::tools {

/// The first that is not done speaks at once; what the others say is kept until it is their turn. So the output is the
/// same for any number of threads. May be called from all of them; speakers are numbered from 0.
class InTurn {
 public:
  enum class To { output, error };

  explicit InTurn(std::size_t speakers) : kept_(speakers), done_(speakers) {}

  /// Throws base::InputError where standard output cannot be written.
  void say(std::size_t speaker, To to, const std::string& text);
  void done(std::size_t speaker);
  [[nodiscard]] bool has_the_word(std::size_t speaker);

 private:
  std::mutex mutex_;
  std::vector<std::vector<std::pair<To, std::string>>> kept_;
  std::vector<bool> done_;
  std::size_t first_ = 0;  ///< that is not done
};

}  // namespace rmpl::tools
