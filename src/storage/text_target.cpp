#include "storage/text_target.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace zenosphere {

bool is_standard_output(const std::filesystem::path& name) {
  constexpr std::array<std::string_view, 4> names{"-", "/dev/stdout", "/dev/fd/1",
                                                  "/proc/self/fd/1"};
  return std::find(names.begin(), names.end(), name.string()) != names.end();
}

TextTarget::TextTarget(const std::filesystem::path& name, Existing existing) {
  if (is_standard_output(name)) {
    file_.emplace(NewFile::standard_output);
    return;
  }
  target_.emplace(name, existing);
  file_.emplace(target_->path(), name);
}

void TextTarget::finish() {
  file_->close();
  if (target_) target_->put_in_place();
}

}  // namespace zenosphere
