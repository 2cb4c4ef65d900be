#include "campaign/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <array>
#include <cmath>
#include <fstream>
#include <system_error>

#include "model/errors.hpp"
#include "text/file_kind.hpp"

namespace zenosphere {
namespace {

/// Long enough for another program to end what it is doing with the file [ms].
constexpr int busy_milliseconds = 10'000;

/// What the user can do about an error of the library.
std::string advice(int code) {
  switch (code & 0xFF) {
    case SQLITE_NOTADB:
      return "is not the store of a sweep ({}); choose another file";
    case SQLITE_CORRUPT:
      return "is damaged ({}); restore a copy of it, or begin another store with -o";
    case SQLITE_FULL:
    case SQLITE_IOERR:
      return "could not be written or read ({}); make room and start the same command again: "
             "what is stored is kept";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "is in use by another program ({}); end that one";
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
      return "could not be opened for this ({}); check the name, the folder and its permissions";
    default:
      return "cannot be used ({})";
  }
}

[[noreturn]] void fail(const std::string& name, sqlite3* database, int code) {
  const char* reason = database ? sqlite3_errmsg(database) : sqlite3_errstr(code);
  const std::string text = name + ": " + fmt::format(fmt::runtime(advice(code)), reason);
  if ((code & 0xFF) == SQLITE_NOTADB) throw InputError(text);
  throw OutputError(text);
}

}  // namespace

bool is_database(const std::filesystem::path& file) {
  constexpr std::string_view head("SQLite format 3\0", 16);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  std::array<char, head.size()> begin{};
  std::ifstream(file, std::ios::binary).read(begin.data(), begin.size());
  return std::string_view(begin.data(), begin.size()) == head;
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

void Statement::start(std::span<const Cell> parameters) {
  sqlite3_stmt* statement = statement_.get();
  sqlite3_reset(statement);
  for (std::size_t n = 0; n < parameters.size(); ++n) {
    const int at = static_cast<int>(n) + 1;
    int code = SQLITE_OK;
    if (const auto* integer = std::get_if<std::int64_t>(&parameters[n])) {
      code = sqlite3_bind_int64(statement, at, *integer);
    } else if (const auto* real = std::get_if<double>(&parameters[n])) {
      code = std::isfinite(*real) ? sqlite3_bind_double(statement, at, *real)
                                  : sqlite3_bind_null(statement, at);
    } else if (const auto* text = std::get_if<std::string>(&parameters[n])) {
      code = sqlite3_bind_text64(statement, at, text->data(), text->size(), SQLITE_TRANSIENT,
                                 SQLITE_UTF8);
    } else {
      code = sqlite3_bind_null(statement, at);
    }
    if (code != SQLITE_OK) fail(name_, sqlite3_db_handle(statement), code);
  }
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  fail(name_, sqlite3_db_handle(statement_.get()), code);
}

Cell Statement::cell(int column) const {
  sqlite3_stmt* statement = statement_.get();
  switch (sqlite3_column_type(statement, column)) {
    case SQLITE_INTEGER:
      return sqlite3_column_int64(statement, column);
    case SQLITE_FLOAT:
      return sqlite3_column_double(statement, column);
    case SQLITE_NULL:
      return {};
    default:
      break;
  }
  const auto* text = static_cast<const char*>(sqlite3_column_blob(statement, column));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, column));
  return text ? std::string(text, size) : std::string();
}

int Statement::columns() const { return sqlite3_column_count(statement_.get()); }

std::string Statement::column_name(int column) const {
  return sqlite3_column_name(statement_.get(), column);
}

void Statement::reset() { sqlite3_reset(statement_.get()); }

void Database::Close::operator()(sqlite3* database) const { sqlite3_close(database); }

Database::Database(const std::filesystem::path& path, Access access) : name_(path.string()) {
  std::error_code ignored;
  if (access == Access::read && !std::filesystem::exists(path, ignored)) {
    throw InputError(name_ + ": does not exist; name the store of a sweep");
  }
  const FileKind kind = access == Access::read ? kind_of_file_at(path) : FileKind::other;
  if (kind != FileKind::other && kind != FileKind::store) {
    throw InputError(name_ + ": " + what_it_is(kind));
  }
  const int flags =
      access == Access::read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  sqlite3* opened = nullptr;
  // The library keeps what is named :memory: or file:... elsewhere; a path from / is always a file.
  const std::string file = std::filesystem::absolute(path, ignored).string();
  const int code = sqlite3_open_v2(file.c_str(), &opened, flags, nullptr);
  database_.reset(opened);
  if (code != SQLITE_OK) fail(name_, opened, code);
  sqlite3_busy_timeout(opened, busy_milliseconds);
  sqlite3_extended_result_codes(opened, 1);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
}

void Database::execute(const std::string& sql) {
  const int code = sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(name_, database_.get(), code);
}

Statement Database::statement(std::string_view sql) {
  sqlite3_stmt* prepared = nullptr;
  const int code = sqlite3_prepare_v2(database_.get(), sql.data(), static_cast<int>(sql.size()),
                                      &prepared, nullptr);
  if (code != SQLITE_OK) fail(name_, database_.get(), code);
  return {prepared, name_};
}

Cell Database::value(std::string_view sql) {
  Statement query = statement(sql);
  return query.step() ? query.cell(0) : Cell();
}

std::int64_t Database::integer(std::string_view sql) { return integer_in(value(sql), name_); }

Transaction::~Transaction() {
  if (!is_open_) return;
  try {
    database_.execute("ROLLBACK");
  } catch (const OutputError&) {  // the library has rolled back by itself
  }
}

void Transaction::commit() {
  database_.execute("COMMIT");
  is_open_ = false;
}

std::int64_t integer_in(const Cell& cell, const std::string& name) {
  const auto* integer = std::get_if<std::int64_t>(&cell);
  if (!integer) throw OutputError(name + ": is damaged (an integer is missing in it)");
  return *integer;
}

std::string text_in(const Cell& cell, const std::string& name) {
  const auto* text = std::get_if<std::string>(&cell);
  if (!text) throw OutputError(name + ": is damaged (a text is missing in it)");
  return *text;
}

std::string cell_text(const Cell& cell) {
  const auto text = [](const auto& held) -> std::string {
    using Held = std::decay_t<decltype(held)>;
    if constexpr (std::is_same_v<Held, std::monostate>) return "";
    if constexpr (std::is_same_v<Held, std::string>) return held;
    if constexpr (std::is_arithmetic_v<Held>) return fmt::format("{}", held);
  };
  return std::visit(text, cell);
}

}  // namespace zenosphere
