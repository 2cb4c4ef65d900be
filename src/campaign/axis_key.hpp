#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "case/case_table.hpp"

namespace zenosphere {

/// How a value of a key stands in the store.
enum class Storage { integer, real, text };

/// The storage of what a key holds: counts are integers, numbers real, all else (words, arrays)
/// text.
Storage storage_of(const case_format::Slot& slot);

/// A key that an axis can be over: one of a table of the case, or of one of its [[species]] or
/// [[contact]], `species.heavy.mass` and `contact.light.heavy.restitution`.
class AxisKey {
 public:
  /// The key of that path, or nothing. Whether the case has such a species is not known here.
  static std::optional<AxisKey> named(std::string_view path);

  /// A path that the user probably meant, or nothing.
  static std::optional<std::string> nearest_path(std::string_view path);

  const std::string& table() const { return table_; }
  const std::string& name() const { return name_; }  ///< `restitution`, `heavy.mass`
  std::string path() const { return table_ + '.' + name_; }
  Storage storage() const { return storage_; }

  /// The argument of `--set` that gives the key a value from the store.
  std::string override_of(const std::string& column) const;

  friend bool operator==(const AxisKey& a, const AxisKey& b) {
    return a.table_ == b.table_ && a.name_ == b.name_;
  }

 private:
  AxisKey(std::string_view table, std::string_view name, Storage storage, bool is_file_name)
      : table_(table), name_(name), storage_(storage), is_file_name_(is_file_name) {}

  std::string table_;
  std::string name_;
  Storage storage_;
  bool is_file_name_;
};

/// How many parts the path of a key in a table has: `species.heavy.mass` has three.
int parts_of_path(std::string_view table);

}  // namespace zenosphere
