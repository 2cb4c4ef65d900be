#include "storage/integrity.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include "model/errors.hpp"
#include "storage/checksum.hpp"
#include "storage/durable.hpp"
#include "storage/file_checksum.hpp"
#include "storage/hdf5_contents.hpp"
#include "storage/sandboxed_read.hpp"

namespace zenosphere {
namespace {

namespace fs = std::filesystem;

const std::string own_group = "zenosphere";
const std::string list_name = own_group + "/checksums";

using Seal = std::array<std::uint8_t, sizeof(std::uint32_t)>;

/// CRC-32C of the first `size` bytes of a file, as it is stored.
Seal seal_of(const FileDescriptor& file, std::uint64_t size) {
  const std::uint32_t sum = file_checksum(file, size);
  Seal seal{};
  std::memcpy(seal.data(), &sum, sizeof sum);
  return seal;
}

bool has_list(const hdf5::Handle& file) {
  return hdf5::contains(hdf5::opened(file, own_group), "checksums");
}

/// Bytes behind HDF5's part.
std::int64_t bytes_behind(const hdf5::Handle& file, const fs::path& path) {
  return static_cast<std::int64_t>(fs::file_size(path)) - hdf5::end_of(file);
}

/// The last line of the list, about those before it.
std::string last_line(const std::string& lines) {
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(lines.data());
  return fmt::format("{:08x} of the lines above\n", checksum({bytes, lines.size()}));
}

/// The lines of the list without the last one; nothing where that does not fit them.
std::vector<std::string> listed_lines(const std::string& list) {
  const std::size_t length = last_line("").size();
  if (list.size() < length) return {};
  const std::string lines = list.substr(0, list.size() - length);
  if (lines + last_line(lines) != list) return {};
  std::istringstream stream(lines);
  std::vector<std::string> result;
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

std::string line_of(const hdf5::Handle& file, const std::string& name) {
  return hdf5::digest(file, name) + ' ' + name;
}

/// What follows the checksum, the type and the extents.
std::string name_in(const std::string& line) {
  std::size_t begin = 0;
  for (int word = 0; word < 3; ++word) begin = line.find(' ', begin) + 1;
  return line.substr(begin);
}

/// Whether a value is what its line says.
bool is_unchanged(const hdf5::Handle& file, const std::string& line, const std::string& name) {
  try {
    return line_of(file, name) == line;
  } catch (const hdf5::Error&) {  // it is gone, or cannot be read any more
    return false;
  }
}

/// Names of the values in the list that have changed.
std::vector<std::string> changed_values(const hdf5::Handle& file) {
  if (!has_list(file)) return {list_name};
  const auto lines = listed_lines(hdf5::text(file, list_name));
  if (lines.empty()) return {list_name};
  std::vector<std::string> changed;
  for (const std::string& line : lines) {
    const std::string name = name_in(line);
    if (!is_unchanged(file, line, name)) changed.push_back(name);
  }
  return changed;
}

std::string shown(const std::string& name) {
  const auto mark = name.find('@');
  if (mark == std::string::npos) return '/' + name;
  return fmt::format("the attribute {} of /{}", name.substr(mark + 1), name.substr(0, mark));
}

[[noreturn]] void reject_damaged(const fs::path& path, const std::string& what) {
  throw InputError(fmt::format(
      "{}: is damaged ({}); take another copy of it, or run its case again", path.string(), what));
}

/// Throws InputError where a file has changed.
void compare_all(const hdf5::Handle& file, const fs::path& path) {
  const std::int64_t behind = bytes_behind(file, path);
  if (behind == sizeof(Seal)) {
    const FileDescriptor bytes(path, O_RDONLY);
    const auto end = static_cast<std::uint64_t>(hdf5::end_of(file));
    const Bytes stored = read_at(bytes, end, sizeof(Seal));
    if (std::ranges::equal(stored, seal_of(bytes, end))) return;
  }
  if (!has_list(file) && behind == 0) return;
  const auto changed = changed_values(file);
  if (changed.size() > 1) {
    reject_damaged(path, fmt::format("{} and {} more are not what was written",
                                     shown(changed.front()), changed.size() - 1));
  }
  if (changed.size() == 1)
    reject_damaged(path, shown(changed.front()) + " is not what was written");
  if (behind != 0) {
    reject_damaged(path, "outside of its datasets and attributes, which are what was written");
  }
}

/// Likewise; nothing happens where it is no output of this program.
void examine(const fs::path& path) {
  hdf5::Handle file;
  try {
    file = hdf5::opened_file(path);
  } catch (const hdf5::Error&) {
    return;
  }
  try {
    if (!hdf5::contains(file, own_group)) return;
    compare_all(file, path);
  } catch (const hdf5::Error& error) {
    reject_damaged(path, fmt::format("its checksums cannot be read, {}", error.what()));
  } catch (const SystemError& error) {
    reject_damaged(path, fmt::format("it cannot be read, {}", error.what()));
  }
}

}  // namespace

std::string sentence(Integrity integrity) {
  switch (integrity) {
    case Integrity::unread:
      return "not read, since the file is large (zenosphere verify reads all of it)";
    case Integrity::unknown:
      return "none, as in unfinished files and those of zenosphere 0.1: not checked";
    case Integrity::values_unchanged:
      return "match: every dataset and attribute is as it was written";
    case Integrity::bytes_unchanged:
      return "match: every byte is as it was written";
  }
  return "";
}

void write_checksums(const hdf5::Handle& file) {
  std::string lines;
  for (const std::string& name : hdf5::value_names(file)) {
    if (name != list_name) lines += line_of(file, name) + '\n';
  }
  hdf5::write_text(hdf5::opened(file, own_group), "checksums", lines + last_line(lines));
}

void seal(const fs::path& path) {
  const FileDescriptor file(path, O_RDWR);
  const std::uint64_t size = size_of(file);
  write_at(file, size, seal_of(file, size));
}

Integrity checked_integrity(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored) || !hdf5::is_hdf5(path)) return Integrity::unknown;
  const auto bytes = static_cast<std::int64_t>(fs::file_size(path));
  sandboxed_read(path, bytes, [&] { examine(path); });
  try {
    const hdf5::Handle file = hdf5::opened_file(path);
    const bool is_ours = hdf5::contains(file, own_group);
    if (!is_ours || !has_list(file)) return Integrity::unknown;
    return bytes_behind(file, path) == 0 ? Integrity::values_unchanged : Integrity::bytes_unchanged;
  } catch (const hdf5::Error&) {
    return Integrity::unknown;  // who reads it next says why
  }
}

}  // namespace zenosphere
