#pragma once

#include <string>

namespace zenosphere {

/// How to cite this program, from the CITATION.cff that it was built with: two
/// paragraphs, without a line break at the end.
std::string citation_text();

/// The same as an entry for BibTeX (biblatex's @software).
std::string citation_bibtex();

}  // namespace zenosphere
