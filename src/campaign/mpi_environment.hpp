#pragma once

namespace zenosphere {

/// How many copies of this program mpirun or srun has started together, as their environment tells
/// each of them; 1 otherwise. Asks no MPI library.
int ranks_in_environment();

/// The same for another environment.
///
/// \param variable  the value of an environment variable, or null
int ranks_in_environment(const char* (*variable)(const char* name));

}  // namespace zenosphere
