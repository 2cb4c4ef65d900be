#include "io/case_words.hpp"

namespace zenosphere {

const char* word(Precision precision) {
  switch (precision) {
    case Precision::extended:
      return "extended";
    case Precision::quad:
      return "quad";
    case Precision::digits100:
      return "digits100";
    case Precision::double_precision:
      break;
  }
  return "double";
}

const char* word(OverlapRule rule) {
  switch (rule) {
    case OverlapRule::immediate:
      return "immediate";
    case OverlapRule::guarded:
      return "guarded";
    case OverlapRule::stop:
      return "stop";
    case OverlapRule::rewind:
      break;
  }
  return "rewind";
}

}  // namespace zenosphere
