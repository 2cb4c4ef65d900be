#include "storage/output_info.hpp"

#include "storage/hdf5.hpp"
#include "storage/journal_tail.hpp"
#include "storage/stored_info.hpp"

namespace zenosphere {

OutputInfo read_output_info(const std::filesystem::path& path) {
  auto [info, tail] = with_journal<OutputInfo>(path, [&] { return read_stored_info(path); });
  tail.add_to(info);
  return std::move(info);
}

bool is_hdf5_file(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) && hdf5::is_hdf5(path);
}

}  // namespace zenosphere
