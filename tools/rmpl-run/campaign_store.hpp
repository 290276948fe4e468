// Where the results of a campaign stand: an SQLite database that many processes write, each result once.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/temporary_folder.hpp"
#include "runtime/executive/campaign/flight.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace rmpl::tools {

/// As SQLite calls a database that is forgotten. There each connection has one of its own; here all see the same.
inline constexpr const char* in_memory = ":memory:";

/// A database in a folder of its own, removed with this. Throws base::InputError where there can be none.
class ForgottenDatabase {
 public:
  [[nodiscard]] std::string path() const { return (folder_.path() / "runs.sqlite").string(); }

 private:
  base::TemporaryFolder folder_ = base::TemporaryFolder::of_system("rmpl-campaign-");
};

/// One connection; each thread has its own. Throws base::InputError where the file is no database of a campaign, or
/// cannot be read or written. A run is a transaction of its own: it is there in full, or not.
class CampaignStore {
 public:
  /// Opens, or makes, the database. What `identity` says has to be what it says there already.
  CampaignStore(std::string path, const automata::Plant& plant, const std::map<std::string, std::string>& identity);

  /// Writes a result, unless it is there.
  void add(const runtime::CampaignRun& run);
  [[nodiscard]] bool has(std::uint64_t run);
  /// Results among the first `runs`.
  [[nodiscard]] std::uint64_t count(std::uint64_t runs);
  /// Of those, how many did not meet what is expected, but for those that are impossible for the model.
  [[nodiscard]] std::uint64_t count_failed(std::uint64_t runs);
  /// The first `runs` in order, as they were added.
  void read(std::uint64_t runs, const std::function<void(const runtime::CampaignRun&)>& take);

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  class Statement;

  void execute(const char* sql);
  void check_identity(const std::map<std::string, std::string>& identity);
  void write(const runtime::CampaignRun& run);
  [[noreturn]] void fail() const;

  std::string path_;
  const automata::Plant& plant_;
  std::unique_ptr<sqlite3, Close> database_;
};

/// Claims on runs, among all processes and threads that work on one database, on any machine that shares its file
/// system: locks on single bytes of a file beside it. The system frees them with the process that dies, and so its runs
/// in flight are done again. A thread has its own.
class CampaignClaims {
 public:
  explicit CampaignClaims(const std::string& database);
  ~CampaignClaims();
  CampaignClaims(const CampaignClaims&) = delete;
  CampaignClaims& operator=(const CampaignClaims&) = delete;

  /// Whether the run is ours now.
  bool claim(std::uint64_t run);
  void release(std::uint64_t run);
  static std::string path(const std::string& database) { return database + ".claims"; }

 private:
  /// Of the byte that stands for the run; whether it could be had.
  bool set_lock(std::uint64_t run, short kind);

  int file_;
};

}  // namespace rmpl::tools
