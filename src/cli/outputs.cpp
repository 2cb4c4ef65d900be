#include "cli/outputs.hpp"

#include <fmt/format.h>

#include <system_error>

#include "model/errors.hpp"
#include "storage/text_target.hpp"

namespace zenosphere {

void require_name(const std::string& output) {
  if (!output.empty()) return;
  throw InputError("-o: the file name is empty (an unset shell variable?); name a file");
}

void require_file_name(const std::string& output, const std::string& why) {
  require_name(output);
  if (!is_standard_output(output)) return;
  throw InputError(
      fmt::format("-o {}: cannot go to standard output ({}); name a file", output, why));
}

void require_other_than(const std::filesystem::path& input, const std::string& output,
                        const std::string& what) {
  std::error_code ignored;  // what does not exist is not the input
  if (!std::filesystem::equivalent(output, input, ignored)) return;
  throw OutputError(fmt::format("{}: is {}; choose another name", output, what));
}

}  // namespace zenosphere
