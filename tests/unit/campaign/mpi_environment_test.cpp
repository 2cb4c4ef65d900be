#include "campaign/mpi_environment.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace zenosphere {
namespace {

TEST(RanksInEnvironment, IsOneWithoutALauncher) {
  EXPECT_EQ(ranks_in_environment([](const char*) -> const char* { return nullptr; }), 1);
}

TEST(RanksInEnvironment, IsWhatOpenMpiSays) {
  EXPECT_EQ(ranks_in_environment([](const char* name) -> const char* {
              return std::string_view(name) == "OMPI_COMM_WORLD_SIZE" ? "3" : nullptr;
            }),
            3);
}

TEST(RanksInEnvironment, IsTheSizeOfTheStepUnderSrunWithPmix) {
  EXPECT_EQ(ranks_in_environment([](const char* name) -> const char* {
              if (std::string_view(name) == "PMIX_RANK") return "0";
              return std::string_view(name) == "SLURM_STEP_NUM_TASKS" ? "4" : nullptr;
            }),
            4);
}

TEST(RanksInEnvironment, IsOneInABatchScriptOfManyTasks) {
  EXPECT_EQ(ranks_in_environment([](const char* name) -> const char* {
              return std::string_view(name) == "SLURM_NTASKS" ? "4" : nullptr;
            }),
            1);
}

}  // namespace
}  // namespace zenosphere
