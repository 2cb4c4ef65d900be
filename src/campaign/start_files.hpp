#pragma once

#include "campaign/database.hpp"
#include "campaign/sweep.hpp"

namespace zenosphere {

/// Keeps in a store what the files are that runs of its sweep start from: their sizes and
/// checksums.
///
/// A file that cannot be read is left to the runs, which tell why. Throws InputError where a run
/// that is done has started from another content than the file has now: runs of one store belong
/// together.
void keep_start_files(Database& database, const Sweep& sweep);

}  // namespace zenosphere
