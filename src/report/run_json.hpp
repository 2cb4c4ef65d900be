#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "report/frames.hpp"
#include "report/frequent_pairs.hpp"
#include "storage/run_reader.hpp"

namespace zenosphere {

/// What the page of a run says of one stretch of its log.
struct StretchName {
  std::string name;  ///< of its columns
  std::int64_t width = 1;
  std::size_t bins = 0;
  std::int64_t last = 0;  ///< number of its last collision
};

/// Everything on the page of a run that is not a column of numbers, as one JSON object: page/README
/// names its members. Text that is not UTF-8 is replaced by U+FFFD.
///
/// \param name   of the output file
/// \param pairs  of the raster of a log that is too long to be kept
std::string run_json(const std::string& name, const RunReader& file, const Case& values,
                     const Frames& frames, const std::vector<StretchName>& stretches,
                     const std::vector<PairCount>& pairs);

}  // namespace zenosphere
