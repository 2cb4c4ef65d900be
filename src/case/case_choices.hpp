#pragma once

#include "case/case.hpp"
#include "model/word_table.hpp"

namespace zenosphere::case_format {

/// The word for a choice, which stands beside it in the header of its table.
template <class Choice>
const char* word_for(Choice choice) {
  return word_in(words_of(choice), choice);
}

}  // namespace zenosphere::case_format
