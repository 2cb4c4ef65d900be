#include "campaign/mpi_environment.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace zenosphere {

int ranks_in_environment(const char* (*variable)(const char* name)) {
  // Open MPI's mpirun; MPICH's mpirun and srun --mpi=pmi2; MVAPICH; every srun.
  constexpr std::array sizes{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE"};
  int ranks = 1;
  for (const char* name : sizes) {
    if (const char* value = variable(name)) ranks = std::max(ranks, std::atoi(value));
  }
  // srun --mpi=pmix tells the rank by itself and the size as the size of the step.
  const char* step = variable("SLURM_STEP_NUM_TASKS");
  if (variable("PMIX_RANK") && step) ranks = std::max(ranks, std::atoi(step));
  return ranks;
}

int ranks_in_environment() {
  return ranks_in_environment([](const char* name) -> const char* { return std::getenv(name); });
}

}  // namespace zenosphere
