#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zenosphere {

/// What to do with a page that is there already.
enum class ExistingPage { refuse, replace };

/// A JSON text that may stand in an HTML script: no `<` is left in it.
std::string as_script(std::string_view json);

/// Writes a page: the template with data in the place of its mark.
///
/// The page gets its name when it is complete; until then there is `PAGE.part-` and the number of
/// the process. Every member throws OutputError, and a page that was not finished leaves nothing.
class PageWriter {
 public:
  /// Throws where the folder is missing, the page exists and may not be replaced, or this program
  /// has no template.
  PageWriter(const std::filesystem::path& path, ExistingPage existing);
  PageWriter(const PageWriter&) = delete;
  PageWriter& operator=(const PageWriter&) = delete;
  ~PageWriter();

  /// Adds a JSON text that the page finds by a name.
  void add_json(std::string_view name, std::string_view json);

  /// Adds numbers that the page finds by a name, little-endian.
  template <class T>
  void add_column(std::string_view name, const std::vector<T>& values) {
    add_bytes(name, type_name<T>(),
              {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)});
  }

  /// Writes the rest and gives the page its name. The last call.
  void finish();

 private:
  template <class T>
  static constexpr std::string_view type_name();

  void add_bytes(std::string_view name, std::string_view type, std::span<const std::uint8_t> bytes);
  void write(std::string_view text);
  [[noreturn]] void fail(int error) const;

  std::filesystem::path path_, part_;
  std::string_view rest_;  ///< of the template
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

template <>
constexpr std::string_view PageWriter::type_name<double>() {
  return "float64";
}
template <>
constexpr std::string_view PageWriter::type_name<float>() {
  return "float32";
}
template <>
constexpr std::string_view PageWriter::type_name<std::int32_t>() {
  return "int32";
}
template <>
constexpr std::string_view PageWriter::type_name<std::uint8_t>() {
  return "uint8";
}

}  // namespace zenosphere
