#include "report/page_writer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/errors.hpp"
#include "report/page_template.hpp"
#include "text/base64.hpp"

namespace zenosphere {
namespace {

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

PageWriter::PageWriter(const std::filesystem::path& path, Existing existing)
    : rest_(whole_template()), page_(path, existing), file_(page_.path(), path) {
  const std::size_t mark = rest_.find(data_mark);
  file_.write(rest_.substr(0, mark));
  rest_.remove_prefix(std::min(rest_.size(), mark + data_mark.size()));
}

void PageWriter::add_json(std::string_view name, std::string_view json) {
  file_.write(fmt::format("<script type=\"application/json\" id=\"{}\">", name));
  file_.write(as_script(json));
  file_.write("</script>\n");
}

void PageWriter::add_bytes(std::string_view name, std::string_view type,
                           std::span<const std::uint8_t> bytes) {
  file_.write(fmt::format("<script type=\"text/plain\" id=\"{}\" data-type=\"{}\">", name, type));
  constexpr std::size_t piece = 3 << 16;  // a multiple of three needs no padding between pieces
  for (std::size_t first = 0; first < bytes.size(); first += piece) {
    file_.write(base64(bytes.subspan(first, std::min(piece, bytes.size() - first))));
  }
  file_.write("</script>\n");
}

void PageWriter::finish() {
  file_.write(rest_);
  file_.close();
  page_.put_in_place();
}

}  // namespace zenosphere
