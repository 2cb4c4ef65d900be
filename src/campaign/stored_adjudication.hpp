#pragma once

#include <map>
#include <optional>
#include <string>

#include "campaign/adjudication_request.hpp"
#include "campaign/database.hpp"
#include "campaign/stored_sweep.hpp"

namespace zenosphere {

/// Gives the table `sweep` of a store the columns of an adjudication request.
void add_request_columns(Database& database);

/// Makes a store tell how its hits are adjudicated, or that they are not.
void write_request(Database& database, const std::optional<AdjudicationRequest>& request);

/// Adds to `sweep` what a store says about adjudications; one of the first format says nothing.
void read_request(Database& database, StoredSweep& sweep);

/// Every key of [adjudicate] as it counts, as text.
std::map<std::string, std::string> settings(const std::optional<AdjudicationRequest>& request);

/// Gives a store of an older format the tables of this one.
void upgrade(Database& database, const StoredSweep& stored);

/// A condition of SQL: the run is done, and its hits are still to be adjudicated.
std::string waits_for_adjudication(const StoredSweep& sweep);

}  // namespace zenosphere
