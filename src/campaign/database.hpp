#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

struct sqlite3;
struct sqlite3_stmt;

namespace zenosphere {

/// One value of a row: nothing, an integer, a real number or text.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string>;

/// A value, or NULL.
template <class T>
Cell or_null(const std::optional<T>& value) {
  return value ? Cell(*value) : Cell();
}

/// Whether a file begins as every SQLite database does.
bool is_database(const std::filesystem::path& file);

/// A prepared statement of an SQLite database, which must outlive it.
class Statement {
 public:
  /// Starts it anew with these values for its parameters; a number that is not finite is stored as
  /// NULL. Throws OutputError.
  void start(std::span<const Cell> parameters);

  /// Goes to the next row. Throws OutputError.
  ///
  /// \return  whether there is one
  bool step();

  /// The value of the row in a column, from 0.
  Cell cell(int column) const;
  int columns() const;
  std::string column_name(int column) const;

  /// Does it as a whole, for what has no rows.
  void run(std::span<const Cell> parameters) {
    start(parameters);
    while (step()) {
    }
    reset();
  }

  /// Lets go of what it holds of the database.
  void reset();

 private:
  friend class Database;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  Statement(sqlite3_stmt* statement, std::string name)
      : statement_(statement), name_(std::move(name)) {}

  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  std::string name_;  ///< of the file
};

/// An SQLite file. It is told to trust no schema of unknown origin.
///
/// What goes wrong is an OutputError that names the file and says what can be done.
class Database {
 public:
  enum class Access { read, write };  ///< `write` creates the file where there is none

  Database(const std::filesystem::path& path, Access access);

  void execute(const std::string& sql);
  Statement statement(std::string_view sql);

  /// The first value of the first row, or nothing.
  Cell value(std::string_view sql);
  std::int64_t integer(std::string_view sql);

  const std::string& name() const { return name_; }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::string name_;
  std::unique_ptr<sqlite3, Close> database_;
};

/// A group of statements that happens as a whole or, where it is not committed, not at all.
class Transaction {
 public:
  explicit Transaction(Database& database) : database_(database) {
    database.execute("BEGIN IMMEDIATE");
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();

  void commit();

 private:
  Database& database_;
  bool is_open_ = true;
};

/// The integer or text in a cell. Throws OutputError, `name` is damaged, where it is another kind.
std::int64_t integer_in(const Cell& cell, const std::string& name);
std::string text_in(const Cell& cell, const std::string& name);

/// The cell as plain text: empty for nothing, the shortest digits that read back to the same bits.
std::string cell_text(const Cell& cell);

}  // namespace zenosphere
