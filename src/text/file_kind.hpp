#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace zenosphere {

/// The kinds of files that a user may name in the place of one another.
enum class FileKind { other, output, store, sweep, case_file };

/// The kind of a file.
///
/// \param beginning  its first bytes, or all of them
FileKind kind_of_file(std::string_view beginning);

/// The same for a file by its name; `other` where it cannot be read.
FileKind kind_of_file_at(const std::filesystem::path& file);

/// `is a case file; zenosphere run runs it`: what the file is, and which commands read it. Empty
/// for FileKind::other.
std::string what_it_is(FileKind kind);

}  // namespace zenosphere
