#include "case/case_template.hpp"

#include <filesystem>
#include <utility>

#include "case/case_file.hpp"
#include "case/case_reader.hpp"

namespace zenosphere {

Case CaseTemplate::with(std::vector<case_format::Entry> overrides,
                        case_format::Problems& problems) const {
  std::vector<case_format::Entry> entries = entries_;
  for (auto& entry : overrides) {
    std::erase_if(entries, [&](const auto& old) {
      return old.table == entry.table && old.name == entry.name;
    });
    entries.push_back(std::move(entry));
  }
  Case values = case_format::case_of(entries, name_, problems);
  if (!values.start.file.empty()) values.start.file = absolute_from(name_, values.start.file);
  return values;
}

Case CaseTemplate::with(std::span<const std::string> overrides) const {
  case_format::Problems problems;
  Case values = with(case_format::entries_of(overrides, problems), problems);
  problems.throw_if_any();
  return values;
}

}  // namespace zenosphere
