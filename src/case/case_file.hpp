#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "case/case.hpp"

namespace zenosphere {

/// The case that a TOML file describes, with overrides from the command line applied.
///
/// docs/case-file.md lists the keys. An override `KEY=VALUE` has a dotted key, as in
/// `system.restitution=0.2`; it replaces the file's value or adds a missing key, the last one wins.
/// A relative `start.file` is meant from the case file's directory; the case has it absolute.
///
/// \param file       at most 16 MiB of UTF-8, lines of at most 10000 bytes
/// \param overrides  the arguments of `--set`
/// Throws InputError: one line `file:line:column: key = value (why); what to do` for each problem,
/// in the order of the file; problems of overrides follow, then missing keys.
Case read_case(const std::filesystem::path& file, std::span<const std::string> overrides);

/// The case that a TOML text describes; as read_case, for a text that is already here.
///
/// \param name  what the error messages call the text, as a rule its file
Case parse_case(std::string text, const std::string& name, std::span<const std::string> overrides);

/// The text of a case file: at most 16 MiB. Throws InputError where it cannot be read.
std::string case_text(const std::filesystem::path& file);

/// The absolute name of a file that another one names relative to its own folder.
std::string absolute_from(const std::string& name, const std::string& path);
/// The case of a TOML text that a program has written: as parse_case, but problems name the key
/// only, `name: key = value (why); what to do`, since the user has not seen the lines.
Case parse_written_case(std::string text, const std::string& name,
                        std::span<const std::string> overrides);

/// A complete TOML text of a case: every key that has a value in it, defaults included, in the
/// order of the reference page. parse_case makes the same case of it, bit for bit.
std::string resolved_toml(const Case& values);

}  // namespace zenosphere
