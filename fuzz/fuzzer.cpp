#include "fuzz/readers.hpp"

/// libFuzzer's entry; ZENOSPHERE_FUZZ_TARGET is the function of readers.hpp that is fed.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  zenosphere::fuzz::ZENOSPHERE_FUZZ_TARGET({data, size});
  return 0;
}

/// HDF5 keeps its tables until the process ends (H5dont_atexit), and what a damaged file cost it.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }
