#pragma once

#include <span>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/case_entries.hpp"
#include "case/case_problems.hpp"

namespace zenosphere {

/// What a case file says, read once, for any number of cases that differ in some keys.
class CaseTemplate {
 public:
  /// \param entries  of a case file, no two for the same key
  /// \param name     of that file: stands in front of a problem that has no line, and a relative
  ///                 start.file is meant from its folder
  CaseTemplate(std::vector<case_format::Entry> entries, std::string name)
      : entries_(std::move(entries)), name_(std::move(name)) {}

  /// The case with some keys replaced or added, without a text of its own.
  ///
  /// \param overrides  as case_format::entries_of makes them; the last one for a key counts
  /// \param problems   gets what is wrong; the case is worth something only if nothing was added
  Case with(std::vector<case_format::Entry> overrides, case_format::Problems& problems) const;

  /// The same for arguments of `--set`. Throws InputError where something is wrong.
  Case with(std::span<const std::string> overrides) const;

  const std::vector<case_format::Entry>& entries() const { return entries_; }
  const std::string& name() const { return name_; }

 private:
  std::vector<case_format::Entry> entries_;
  std::string name_;
};

}  // namespace zenosphere
