#pragma once

#include <functional>
#include <string>

#include "campaign/database.hpp"

namespace zenosphere {

/// Writes all rows of a store as comma-separated values (RFC 4180): a line of names, then a line a
/// run; nothing for NULL, real numbers with the digits that read back to the same bits.
///
/// \param write  gets the text in pieces
void write_csv(Database& store, const std::function<void(const std::string&)>& write);

}  // namespace zenosphere
