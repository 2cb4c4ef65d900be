#pragma once

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace zenosphere::xyz {

/// What parts the words of a line.
inline constexpr std::string_view blanks = " \t";

/// The lines of a file of extended XYZ, counted from 1.
class Lines {
 public:
  struct Mark {
    std::streampos position;
    std::int64_t number;
  };

  /// Throws InputError where the file cannot be opened, is no regular file or larger than 64 GiB.
  explicit Lines(const std::filesystem::path& path);

  /// The next line without its end, or null after the last one.
  const std::string* next();

  /// The next line of a file that had it when it was last looked at.
  const std::string& required();

  Mark mark();
  void go_back(const Mark& mark);

  /// Throws an InputError about the line that was read last.
  [[noreturn]] void reject(const std::string& text) const;
  /// Throws an InputError about the whole file.
  [[noreturn]] void reject_file(const std::string& text) const;

 private:
  std::string name_;
  std::ifstream stream_;
  std::string line_;
  std::int64_t number_ = 0;
};

/// Cuts the first word off a text; empty if there is none.
std::string_view next_word(std::string_view& text);

/// A word as messages show it: in quotes, cut where it is long.
std::string shown(std::string_view word);

/// The number that a word is as a whole, or nothing.
template <class Number>
std::optional<Number> number_in(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool is_whole = !word.empty() && end == word.data() + word.size();
  return error == std::errc() && is_whole ? std::optional(number) : std::nullopt;
}

/// The finite number that a word is. Throws InputError, at the line read last, where it is none.
double finite_number(std::string_view word, const Lines& lines);

/// The text in small letters.
std::string lower_case(std::string_view text);

}  // namespace zenosphere::xyz
