#include "report/page_template.hpp"

#include <cstddef>

// page_template.S puts the file here.
extern "C" const char zenosphere_page_begin;
extern "C" const char zenosphere_page_end;

namespace zenosphere {

std::string_view page_template() {
  return {&zenosphere_page_begin,
          static_cast<std::size_t>(&zenosphere_page_end - &zenosphere_page_begin)};
}

}  // namespace zenosphere
