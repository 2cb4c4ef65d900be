#pragma once

#include <filesystem>
#include <string>

namespace zenosphere {

/// Throws InputError where an output was typed that has no name.
void require_name(const std::string& output);

/// Throws InputError where an output was typed that is no name of a file: none, or standard output.
///
/// \param why  for the message: "a store is a database"
void require_file_name(const std::string& output, const std::string& why);

/// Throws OutputError where an output is a file that the command reads, under whatever name.
///
/// \param what  for the message: "the case file itself"
void require_other_than(const std::filesystem::path& input, const std::string& output,
                        const std::string& what);

}  // namespace zenosphere
