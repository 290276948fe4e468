// Two tables: runs, and the faults that were injected in them.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/campaign_store.hpp"

#include <fcntl.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.hpp"

namespace rmpl::tools {
namespace {

constexpr int patience_ms = 120'000;  // for a lock that another process has

constexpr const char* tables = R"(
CREATE TABLE IF NOT EXISTS campaign(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS run(
  run INTEGER PRIMARY KEY, seed INTEGER NOT NULL, verdict TEXT NOT NULL, ended_ns INTEGER, time_ns INTEGER NOT NULL,
  cycles INTEGER NOT NULL, right_cycles INTEGER NOT NULL, chance_faults INTEGER NOT NULL);
CREATE TABLE IF NOT EXISTS fault(
  run INTEGER NOT NULL REFERENCES run(run), number INTEGER NOT NULL, component TEXT NOT NULL, mode TEXT NOT NULL,
  at_ns INTEGER NOT NULL, forced_ns INTEGER, symptom_ns INTEGER, named_ns INTEGER,
  PRIMARY KEY(run, number)) WITHOUT ROWID;)";

using Time = std::optional<automata::Ticks>;

}  // namespace

void CampaignStore::Close::operator()(sqlite3* database) const { sqlite3_close(database); }

/// A prepared statement: bind in order, step, read in order.
class CampaignStore::Statement {
 public:
  Statement(CampaignStore& store, const char* sql) : store_(store) {
    if (sqlite3_prepare_v2(store_.database_.get(), sql, -1, &statement_, nullptr) != SQLITE_OK) store_.fail();
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& bind(std::uint64_t number) {
    sqlite3_bind_int64(statement_, ++bound_, static_cast<sqlite3_int64>(number));
    return *this;
  }
  Statement& bind(std::string_view text) {
    sqlite3_bind_text(statement_, ++bound_, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
    return *this;
  }
  Statement& bind(const Time& time) {
    if (time) return bind(static_cast<std::uint64_t>(time->count));
    sqlite3_bind_null(statement_, ++bound_);
    return *this;
  }
  /// Whether there is a row.
  bool step() {
    read_ = 0;
    const int result = sqlite3_step(statement_);
    if (result != SQLITE_ROW && result != SQLITE_DONE) store_.fail();
    return result == SQLITE_ROW;
  }
  std::uint64_t number() { return static_cast<std::uint64_t>(sqlite3_column_int64(statement_, read_++)); }
  std::string text() {
    const unsigned char* text = sqlite3_column_text(statement_, read_++);
    return text == nullptr ? "" : reinterpret_cast<const char*>(text);
  }
  Time time() {
    if (sqlite3_column_type(statement_, read_) == SQLITE_NULL) return ++read_, std::nullopt;
    return automata::Ticks{sqlite3_column_int64(statement_, read_++)};
  }

 private:
  CampaignStore& store_;
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0;
  int read_ = 0;
};

CampaignStore::CampaignStore(std::string path, const automata::Plant& plant,
                             const std::map<std::string, std::string>& identity)
    : path_(std::move(path)), plant_(plant) {
  sqlite3* database = nullptr;
  const int result = sqlite3_open(path_.c_str(), &database);
  database_.reset(database);
  if (result != SQLITE_OK) fail();
  sqlite3_busy_timeout(database, patience_ms);
  execute("PRAGMA synchronous=NORMAL");
  execute("BEGIN IMMEDIATE");
  execute(tables);
  check_identity(identity);
  execute("COMMIT");
}

void CampaignStore::fail() const { throw base::InputError(path_ + ": " + sqlite3_errmsg(database_.get())); }

void CampaignStore::execute(const char* sql) {
  if (sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

void CampaignStore::check_identity(const std::map<std::string, std::string>& identity) {
  for (const auto& [key, value] : identity) {
    Statement known(*this, "SELECT value FROM campaign WHERE key = ?");
    if (!known.bind(key).step()) {
      Statement(*this, "INSERT INTO campaign VALUES(?, ?)").bind(key).bind(value).step();
    } else if (const std::string there = known.text(); there != value) {
      throw base::InputError("--db: " + path_ + " holds the results of another campaign: its " + key + " is '" + there +
                             "', not '" + value + "'");
    }
  }
}

bool CampaignStore::has(std::uint64_t run) {
  return Statement(*this, "SELECT 1 FROM run WHERE run = ?").bind(run).step();
}

std::uint64_t CampaignStore::count(std::uint64_t runs) {
  Statement statement(*this, "SELECT count(*) FROM run WHERE run < ?");
  statement.bind(runs).step();
  return statement.number();
}

std::uint64_t CampaignStore::count_failed(std::uint64_t runs) {
  Statement statement(*this, "SELECT count(*) FROM run WHERE run < ? AND verdict IN ('failed', 'undecided')");
  statement.bind(runs).step();
  return statement.number();
}

void CampaignStore::add(const runtime::CampaignRun& run) {
  execute("BEGIN IMMEDIATE");
  if (!has(run.run)) write(run);
  execute("COMMIT");
}

void CampaignStore::write(const runtime::CampaignRun& run) {
  Statement row(*this, "INSERT INTO run VALUES(?, ?, ?, ?, ?, ?, ?, ?)");
  row.bind(run.run).bind(run.seed).bind(runtime::name_of(run.verdict)).bind(run.ended).bind(Time(run.time));
  row.bind(run.cycles).bind(run.right).bind(run.by_chance).step();
  std::uint64_t number = 0;
  for (const runtime::Injected& injected : run.injected) {
    const automata::Component& component = plant_[injected.fault.component];
    Statement fault(*this, "INSERT INTO fault VALUES(?, ?, ?, ?, ?, ?, ?, ?)");
    fault.bind(run.run).bind(++number).bind(component.name).bind(component.modes[injected.fault.mode.index()].name);
    fault.bind(Time(injected.fault.at)).bind(injected.forced).bind(injected.symptom).bind(injected.named).step();
  }
}

void CampaignStore::read(std::uint64_t runs, const std::function<void(const runtime::CampaignRun&)>& take) {
  using Verdict = runtime::CampaignRun::Verdict;
  Statement rows(*this, "SELECT * FROM run WHERE run < ? ORDER BY run");
  rows.bind(runs);
  while (rows.step()) {
    runtime::CampaignRun run;
    run.run = rows.number();
    run.seed = rows.number();
    const std::string verdict = rows.text();
    for (const Verdict known : {Verdict::met, Verdict::failed, Verdict::undecided, Verdict::impossible}) {
      if (runtime::name_of(known) == verdict) run.verdict = known;
    }
    run.ended = rows.time();
    run.time = rows.time().value_or(automata::Ticks{});
    run.cycles = rows.number();
    run.right = rows.number();
    run.by_chance = rows.number();
    Statement faults(*this,
                     "SELECT component, mode, at_ns, forced_ns, symptom_ns, named_ns FROM fault WHERE run = ? "
                     "ORDER BY number");
    for (faults.bind(run.run); faults.step();) {
      runtime::Injected injected;
      const auto component = plant_.find_component(faults.text());
      if (!component) throw base::InputError(path_ + ": names a component that the plant lacks");
      const std::string mode = faults.text();
      injected.fault.component = *component;
      const auto& modes = plant_[*component].modes;
      for (std::size_t m = 0; m < modes.size(); ++m) {
        if (modes[m].name == mode) injected.fault.mode = automata::ModeId(m);
      }
      injected.fault.at = faults.time().value_or(automata::Ticks{});
      injected.forced = faults.time();
      injected.symptom = faults.time();
      injected.named = faults.time();
      run.injected.push_back(injected);
    }
    take(run);
  }
}

CampaignClaims::CampaignClaims(const std::string& database)
    : file_(::open(path(database).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (file_ < 0) throw base::InputError(path(database) + ": " + std::strerror(errno));
}

CampaignClaims::~CampaignClaims() { ::close(file_); }

bool CampaignClaims::claim(std::uint64_t run) { return set_lock(run, F_WRLCK); }

void CampaignClaims::release(std::uint64_t run) { set_lock(run, F_UNLCK); }

bool CampaignClaims::set_lock(std::uint64_t run, short kind) {
  struct flock lock = {};
  lock.l_type = kind;
  lock.l_whence = SEEK_SET;
  lock.l_start = static_cast<off_t>(run);
  lock.l_len = 1;
  return fcntl(file_, F_OFD_SETLK, &lock) == 0;
}

}  // namespace rmpl::tools
