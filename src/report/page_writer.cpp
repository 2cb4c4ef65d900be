#include "report/page_writer.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "model/errors.hpp"
#include "report/page_template.hpp"
#include "text/base64.hpp"

namespace zenosphere {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void tell_failure(const fs::path& path, int error) {
  throw OutputError(fmt::format("{}: could not be written ({}); choose another place",
                                path.string(), std::strerror(error)));
}

void require_writable(const fs::path& path, ExistingPage existing) {
  const auto refuse = [&](const std::string& text) {
    throw OutputError(path.string() + ": " + text);
  };
  std::error_code ignored;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (!fs::is_directory(folder, ignored)) {
    refuse(fmt::format("there is no folder {}; create it or choose another", folder.string()));
  }
  const auto status = fs::status(path, ignored);
  if (!fs::exists(status)) return;
  if (!fs::is_regular_file(status)) refuse("is not a regular file; choose another name");
  if (existing == ExistingPage::refuse) {
    refuse("exists already; choose another name or pass --overwrite");
  }
}

std::string_view whole_template() {
  const std::string_view page = page_template();
  if (page.empty()) {
    throw OutputError(
        "zenosphere report: this program was built without its page (npm was missing, or "
        "-DZENOSPHERE_PAGE=OFF); install npm (apt install npm) and run scripts/build again");
  }
  return page;
}

}  // namespace

std::string as_script(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  for (const char character : json) {
    if (character == '<') {
      text += "\\u003c";
    } else {
      text += character;
    }
  }
  return text;
}

PageWriter::PageWriter(const fs::path& path, ExistingPage existing)
    : path_(path), part_(path), rest_(whole_template()), file_(nullptr, std::fclose) {
  require_writable(path, existing);
  part_ += fmt::format(".part-{}", getpid());
  file_.reset(std::fopen(part_.c_str(), "wbx"));  // never what is somebody else's
  if (!file_) tell_failure(path, errno);
  const std::size_t mark = rest_.find(data_mark);
  write(rest_.substr(0, mark));
  rest_.remove_prefix(std::min(rest_.size(), mark + data_mark.size()));
}

PageWriter::~PageWriter() {
  if (!file_) return;
  std::error_code ignored;
  fs::remove(part_, ignored);
}

void PageWriter::add_json(std::string_view name, std::string_view json) {
  write(fmt::format("<script type=\"application/json\" id=\"{}\">", name));
  write(as_script(json));
  write("</script>\n");
}

void PageWriter::add_bytes(std::string_view name, std::string_view type,
                           std::span<const std::uint8_t> bytes) {
  write(fmt::format("<script type=\"text/plain\" id=\"{}\" data-type=\"{}\">", name, type));
  constexpr std::size_t piece = 3 << 16;  // a multiple of three needs no padding between pieces
  for (std::size_t first = 0; first < bytes.size(); first += piece) {
    write(base64(bytes.subspan(first, std::min(piece, bytes.size() - first))));
  }
  write("</script>\n");
}

void PageWriter::finish() {
  write(rest_);
  if (std::fclose(file_.release()) != 0) fail(errno);
  std::error_code error;
  fs::rename(part_, path_, error);
  if (error) fail(error.value());
}

void PageWriter::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail(errno);
}

void PageWriter::fail(int error) const {
  std::error_code ignored;
  fs::remove(part_, ignored);
  tell_failure(path_, error);
}

}  // namespace zenosphere
