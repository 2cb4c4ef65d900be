#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace zenosphere {

/// The case with the kinds of spheres that its start file tells, if it says nothing of them itself.
///
/// Of an output file these are the species of its case; of extended XYZ the spheres that agree in
/// diameter, mass and the word of their kind (a column kind, type or species) are a species, named
/// after that word or by number. Cases that have [[species]] or [polydispersity], and files of unit
/// spheres, are left as they are. The case is checked again with what it has got.
///
/// \param values  a checked case
/// Throws InputError where the file cannot be read or tells more than 256 kinds, where spheres of a
/// kind do not follow one another, or where the case is wrong with them.
Case with_species_of_start(Case values);

/// Throws InputError where a file names kinds of spheres as the case does, but not the same ones.
///
/// \param kinds  a word for each sphere, or none
/// \param where  what the message calls the file
void require_equal_kinds(const std::vector<std::string>& kinds, const Case& values,
                         const std::string& where);

/// HDF5 is not made for threads: held while a start is read.
std::mutex& one_start_at_a_time();

}  // namespace zenosphere
