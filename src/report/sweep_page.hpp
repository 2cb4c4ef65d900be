#pragma once

#include <filesystem>

#include "report/page_writer.hpp"

namespace zenosphere {

/// Writes one HTML page that shows a sweep: how often its runs meet the criteria at each point of
/// the grid, and the runs and the case file of a point that is chosen.
///
/// \param store  of a sweep, finished or not; runs that are still to be done are counted as that
/// Throws OutputError where the store cannot be read or the page cannot be written, InputError
/// where a case of the store is none.
void write_sweep_page(const std::filesystem::path& store, const std::filesystem::path& page,
                      Existing existing);

}  // namespace zenosphere
