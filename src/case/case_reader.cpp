#include "case/case_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <map>
#include <set>
#include <variant>

#include "case/case_grains.hpp"
#include "case/case_hints.hpp"
#include "case/case_rules.hpp"
#include "case/case_table.hpp"
#include "case/species_reader.hpp"

namespace zenosphere::case_format {
namespace {

const Key& key_at(std::string_view path) {
  const std::size_t dot = path.find('.');
  const Key* key = key_named(path.substr(0, dot), path.substr(dot + 1));
  assert(key);
  return *key;
}

/// Turns entries into a case: first each by itself, then each key of the table, then the rules.
class Reader {
 public:
  Reader(const std::string& name, Problems& problems)
      : name_(name), problems_(problems), species_(values_, problems) {}

  void read(const Entry& entry);
  void settle(const Choice& choice);
  void check_presence(const Key& key);
  void check_presence(const Choice& choice);
  void check_species();
  void check(const Rule& rule);
  void scale_threshold();
  const Case& values() const { return values_; }

 private:
  void reject_unknown_table(const Entry& head);
  void reject_unknown_key(const Entry& entry);
  void blame(std::string_view path, const std::string& objection);
  bool was_meant(const Key& key) const;
  bool is_given(std::string_view path) const { return given_.contains(path); }
  bool is_settled(std::string_view path) const { return !unsettled_.contains(path); }
  bool is_overridden(std::string_view path) const;
  bool is_needed(const Key& key) const;
  bool may_stand_idle(const Key& key);
  void reset(const Key& key);

  const std::string& name_;
  Problems& problems_;
  Case values_;
  SpeciesReader species_;
  std::map<std::string, const Entry*, std::less<>> given_;  ///< by path, right or wrong
  std::set<std::string, std::less<>> unsettled_;            ///< keys whose value is not known
  std::set<std::string, std::less<>> tables_;               ///< that are there, maybe empty
  std::set<std::string, std::less<>> unknown_tables_;
  std::set<std::string, std::less<>> meant_;  ///< paths and tables that a wrong name stands for
};

void Reader::read(const Entry& entry) {
  if (SpeciesReader::reads(entry.table)) return species_.read(entry);
  const bool is_head = std::holds_alternative<TableHead>(entry.value);
  tables_.insert(is_head ? entry.name : entry.table);
  if (is_head) return reject_unknown_table(entry);
  if (unknown_tables_.contains(entry.table)) return;  // told once, at its head
  if (entry.table.empty() && is_table(entry.name)) {
    problems_.add(entry.value_place,
                  fmt::format("{} = {} (is a table, not a key); give its keys under [{}]",
                              entry.key(), shown(entry.value), entry.name));
    meant_.insert(entry.name);
    return;
  }
  const Key* key = key_named(entry.table, entry.name);
  if (!key) return reject_unknown_key(entry);
  given_.emplace(key->path(), &entry);
  if (const auto objection = store(key->slot(values_), key->range, entry.value)) {
    blame(key->path(), *objection);
  }
}

void Reader::reject_unknown_table(const Entry& head) {
  if (is_table(head.name) || SpeciesReader::reads(head.name)) return;
  unknown_tables_.insert(head.name);
  const auto meant = nearest_table(head.name);
  if (meant) meant_.emplace(*meant);
  problems_.add(head.key_place, fmt::format("unknown table [{}]", head.key()) +
                                    (meant ? fmt::format("; did you mean [{}]?", *meant) : ""));
}

void Reader::reject_unknown_key(const Entry& entry) {
  std::string text = "unknown key " + entry.key();
  if (const auto hint = hint_among(key_hints, fmt::format("{}.{}", entry.table, entry.name))) {
    text += fmt::format("; did you mean {}?", *hint);
    meant_.insert(std::string(*hint));
  } else if (const Key* meant = nearest_key(entry.table, entry.name)) {
    const bool is_in_sight = meant->table == entry.table && !entry.key_place.is_override();
    text +=
        fmt::format("; did you mean {}?", is_in_sight ? std::string(meant->name) : meant->path());
    meant_.insert(meant->path());
  }
  problems_.add(entry.key_place, text);
}

/// Reports the value that was given for a key and remembers that it is not to be used.
void Reader::blame(std::string_view path, const std::string& objection) {
  const auto given = given_.find(path);
  assert(given != given_.end());  // a default is no mistake of the user
  const Entry& entry = *given->second;
  problems_.add(entry.value_place, fmt::format("{} = {} {}", path, shown(entry.value), objection));
  unsettled_.emplace(path);
}

bool Reader::was_meant(const Key& key) const {
  return meant_.contains(key.path()) || meant_.contains(key.table);
}

bool Reader::is_overridden(std::string_view path) const {
  const auto given = given_.find(path);
  return given != given_.end() && given->second->key_place.is_override();
}

bool Reader::is_needed(const Key& key) const {
  return key.presence == Presence::required ||
         (key.presence == Presence::with_table && tables_.contains(key.table));
}

/// Whether a key that has no meaning in this case is no mistake: it has its default value, or an
/// override took away what it belongs to.
bool Reader::may_stand_idle(const Key& key) {
  Case untouched;
  const Slot default_slot = key.slot(untouched);
  const bool is_default =
      std::visit([&](auto* slot) { return *slot == *std::get<decltype(slot)>(default_slot); },
                 key.slot(values_));
  const auto& others = key.condition->depends_on;
  const auto overridden = [&](std::string_view path) { return is_overridden(path); };
  return is_default ||
         (std::any_of(others.begin(), others.end(), overridden) && !is_overridden(key.path()));
}

/// Gives the key its default again, as if the user had not set it.
void Reader::reset(const Key& key) {
  Case untouched;
  const Slot default_slot = key.slot(untouched);
  std::visit([&](auto* slot) { *slot = *std::get<decltype(slot)>(default_slot); },
             key.slot(values_));
}

/// Leaves at most one of two keys that exclude each other: an override beats the file.
void Reader::settle(const Choice& choice) {
  const auto [first, second] = choice.keys;
  if (!choice.exclusive || !is_given(first) || !is_given(second)) return;
  if (!is_settled(choice.depends_on) || !choice.applies(values_)) return;
  if (is_overridden(first) == is_overridden(second)) {
    return blame(second, fmt::format("({} is given too); remove one of them", first));
  }
  const std::string_view beaten = is_overridden(first) ? second : first;
  reset(key_at(beaten));
  given_.erase(given_.find(beaten));
}

/// Checks that the key is there where it must be, and only there. Needs the keys before it.
void Reader::check_presence(const Key& key) {
  const std::string path = key.path();
  const auto unsettled = [&](std::string_view other) { return !is_settled(other); };
  if (key.condition &&
      std::any_of(key.condition->depends_on.begin(), key.condition->depends_on.end(), unsettled)) {
    unsettled_.insert(path);
    return;
  }
  const bool exists = key.exists_in(values_);
  if (is_given(path)) {
    if (exists || !is_settled(path)) return;
    if (may_stand_idle(key)) return reset(key);
    return blame(path, fmt::format("(only for {}); remove it", key.condition->text));
  }
  if (!is_needed(key) || !exists) return;
  unsettled_.insert(path);
  if (was_meant(key)) return;
  problems_.add(Place::absent(name_),
                fmt::format("missing key {} (physics has no default); add {} = ... under [{}]",
                            path, key.name, key.table));
}

/// Checks that one of the keys is there where one must be.
void Reader::check_presence(const Choice& choice) {
  const auto [first, second] = choice.keys;
  if (is_given(choice.depends_on) && !is_settled(choice.depends_on)) return;
  if (!choice.applies(values_) || is_given(first) || is_given(second)) return;
  const Key& key = key_at(first);
  unsettled_.emplace(first);
  if (!second.empty()) unsettled_.emplace(second);
  if (was_meant(key) || (!second.empty() && was_meant(key_at(second)))) return;
  const std::string add = second.empty() ? fmt::format("{} = ...", key.name) : "one";
  problems_.add(Place::absent(name_),
                fmt::format("missing key {}{}{} ({}); add {} under [{}]", first,
                            second.empty() ? "" : " or ", second, choice.reason, add, key.table));
}

/// What the rules about the box read follows from the species; where these are wrong it is not
/// known.
void Reader::check_species() {
  const auto settled = [&](std::string_view path) { return is_settled(path); };
  constexpr std::array system{"system.dimension", "system.spheres"};
  constexpr std::array others{"start.seed", "polydispersity.distribution", "polydispersity.spread"};
  const bool knows_system = std::all_of(system.begin(), system.end(), settled);
  species_.finish(knows_system);
  if (species_.is_right() && knows_system && std::all_of(others.begin(), others.end(), settled) &&
      spread_objection(values_) == std::nullopt) {
    values_.system.sizes = sizes_of(values_);
    return;
  }
  if (!values_.species.empty())
    unsettled_.insert({"system.solids_volume_fraction", "system.sides"});
}

void Reader::check(const Rule& rule) {
  const auto settled = [&](std::string_view path) { return is_settled(path); };
  if (!std::all_of(rule.keys.begin(), rule.keys.end(), settled)) return;
  if (const auto objection = rule.objection(values_)) blame(rule.keys.front(), *objection);
}

/// A threshold that the user does not fix follows the rounding of the number type.
void Reader::scale_threshold() {
  if (!is_given("collapse.gap_threshold")) {
    values_.collapse.gap_threshold = GapThreshold(values_.collision.precision);
  }
}

}  // namespace

Case case_of(std::span<const Entry> entries, const std::string& name, Problems& problems) {
  Reader reader(name, problems);
  for (const Entry& entry : entries) reader.read(entry);
  for (const Choice& choice : choices()) reader.settle(choice);
  for (const Key& key : keys()) {
    reader.check_presence(key);
    for (const Choice& choice : choices()) {
      if (choice.keys.front() == key.path()) reader.check_presence(choice);
    }
  }
  reader.check_species();
  for (const Rule& rule : rules()) reader.check(rule);
  reader.scale_threshold();
  return reader.values();
}

}  // namespace zenosphere::case_format
