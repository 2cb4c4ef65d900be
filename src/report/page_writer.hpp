#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "storage/atomic_file.hpp"
#include "storage/new_file.hpp"

namespace zenosphere {

/// A JSON text that may stand in an HTML script: no `<` is left in it.
std::string as_script(std::string_view json);

/// Writes a page: the template with data in the place of its mark.
///
/// The page gets its name when it is complete (AtomicFile). Every member throws OutputError.
class PageWriter {
 public:
  /// Throws where the folder is missing, the page exists and may not be replaced, or this program
  /// has no template.
  PageWriter(const std::filesystem::path& path, Existing existing);

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

  std::string_view rest_;  ///< of the template
  AtomicFile page_;
  NewFile file_;
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
