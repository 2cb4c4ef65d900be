#pragma once

namespace zenosphere {

/// What a field of a result is called where it is written down.
///
/// A part of a result lists its fields once, in `fields(self, visit)`, which calls
/// `visit(Field, member)` for each. From that list come its JSON, the reading of it, and the
/// columns in the store of a sweep.
struct Field {
  const char* name;              ///< its key in JSON
  const char* column = nullptr;  ///< its column in the store of a sweep; null: it has none
  bool may_lack = false;         ///< files of earlier versions do not have it
};

/// A part of a result that lists its fields.
template <class Part>
concept HasFields = requires(Part& part) {
  Part::fields(part, [](const Field&, auto&) {});
};

}  // namespace zenosphere
