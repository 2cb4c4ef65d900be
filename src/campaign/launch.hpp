#pragma once

namespace zenosphere {

/// How many copies of this program mpirun or srun has started together, as their environment tells
/// each of them; 1 where nobody did. Asks no MPI library.
int launched_ranks();

/// The same with the environment of somebody else.
///
/// \param variable  the value of an environment variable, or null
int launched_ranks(const char* (*variable)(const char* name));

}  // namespace zenosphere
