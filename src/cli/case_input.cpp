#include "cli/case_input.hpp"

#include "case/case_file.hpp"

namespace zenosphere {

Case case_from(const std::string& file, std::span<const std::string> overrides) {
  if (file != "-") return read_case(file, overrides);
  return parse_case(case_text("/dev/stdin"), "standard input", overrides);
}

}  // namespace zenosphere
