#pragma once

#include <filesystem>
#include <string>

#include "storage/hdf5.hpp"

/// Checksums of a finished output file: which bit has changed since it was written?
///
/// Two kinds, both CRC-32C (docs/file-format.md, docs/decisions/0024-checksums.md): a list of all
/// datasets and attributes, which tells where damage is and outlives a rewriting by other programs;
/// and one checksum of all bytes behind the end of HDF5's part, which finds whatever the list does
/// not see, and is gone as soon as another program writes to the file.
namespace zenosphere {

/// What is known of a file that is not damaged.
enum class Integrity {
  unread,            ///< not examined
  unknown,           ///< it has no checksums: older than them, or not finished
  values_unchanged,  ///< datasets and attributes are what was written
  bytes_unchanged,   ///< the file is
};

/// Writes the list into the group /zenosphere of a file that is open for writing. Throws
/// hdf5::Error.
void write_checksums(const hdf5::Handle& file);

/// Appends the checksum of all bytes to a file that is not open. Throws SystemError.
void seal(const std::filesystem::path& path);

/// Compares a file with its checksums. Reads it once from begin to end, and where it has changed
/// once more.
///
/// What cannot be opened as an HDF5 file has none. Throws InputError where it is damaged, with the
/// name of the dataset or attribute.
Integrity checked_integrity(const std::filesystem::path& path);

/// For a table: "match: every byte is as it was written".
std::string sentence(Integrity integrity);

}  // namespace zenosphere
