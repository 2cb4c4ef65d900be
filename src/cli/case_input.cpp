#include "cli/case_input.hpp"

#include "case/case_file.hpp"
#include "start/start_species.hpp"

namespace zenosphere {

Case case_from(const std::string& file, std::span<const std::string> overrides) {
  return with_species_of_start(
      file != "-" ? read_case(file, overrides)
                  : parse_case(case_text("/dev/stdin"), "standard input", overrides));
}

}  // namespace zenosphere
