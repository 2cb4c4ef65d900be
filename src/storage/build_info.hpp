#pragma once

/// What this program was built from and how; written anew at each build by cmake/build_info.cmake.
namespace zenosphere::build_info {

extern const char* const program_version;  ///< "1.0.0"
extern const char* const citation;         ///< the text of CITATION.cff
extern const char* const git_hash;         ///< 40 digits, "-dirty" behind them where the sources
                                           ///< differ from the commit; "unknown" outside git
extern const char* const compiler;         ///< name and version
extern const char* const compiler_flags;

}  // namespace zenosphere::build_info
