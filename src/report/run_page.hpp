#pragma once

#include <filesystem>

#include "report/page_writer.hpp"

namespace zenosphere {

/// Writes one HTML page that shows a run: verdict, plots of its collisions, its spheres, and how to
/// make it again.
///
/// The page needs neither a network nor other files. Memory and size of the page are bounded: a
/// log of more than LogDigest::most_rows is binned with its extremes kept, and of many snapshots as
/// many are shown as fit into 8 MB, but two at least, and none of more than a million spheres.
///
/// \param output  output file of a run, finished or not, with its journal
/// Throws InputError where it cannot be read, OutputError where the page cannot be written.
void write_run_page(const std::filesystem::path& output, const std::filesystem::path& page,
                    Existing existing);

}  // namespace zenosphere
