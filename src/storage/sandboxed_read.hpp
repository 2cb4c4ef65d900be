#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

namespace zenosphere {

/// Does a reading in a copy of this process first, with bounded time and memory and without the
/// right to write files; where that goes wrong, this process has met nothing of it.
///
/// HDF5 crashes, spins or allocates without bound on some damaged files, deep in the library. The
/// copy has the same memory and reads the same bytes: what went well in it goes well here, where it
/// is to be done again.
///
/// \param path      the file that is read, for the messages
/// \param bytes     what the reading returns, roughly; the copy may take 4 x as much and 256 MiB,
///                  and a second of processor time for each 32 MiB and 2 more
/// \param reading   may throw InputError
/// Throws the InputError of the reading, or one that says how the copy ended.
/// Source: HDF5 1.10 has published crashes on damaged files, for example CVE-2021-37501.
void sandboxed_read(const std::filesystem::path& path, std::int64_t bytes,
                    const std::function<void()>& reading);

}  // namespace zenosphere
