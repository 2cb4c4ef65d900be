#include "cli/shipped_cases.hpp"

#include <algorithm>
#include <array>

namespace zenosphere {

namespace {

constexpr std::string_view paper = "The paper: collapse or not under shear";
constexpr std::string_view few = "A few spheres: collapse that can be worked out";
constexpr std::string_view cooling = "Gases that cool";
constexpr std::string_view driven = "Gases that are sheared, shaken or kicked";
constexpr std::string_view others = "More cases";
constexpr std::string_view sweeps = "Sweeps, for zenosphere sweep";

/// What an example is about; one that is not here comes under `others`.
struct Subject {
  std::string_view name, heading;
};

constexpr std::array subjects{Subject{"shear-e02", paper},
                              Subject{"shear-e06", paper},
                              Subject{"kadanoff-1999-bouncing-ball", few},
                              Subject{"kadanoff-1999-bouncing-column", few},
                              Subject{"bernu-mazighi-1990-three-rods", few},
                              Subject{"dolmaire-huebner-rosenau-2024-four-rods", few},
                              Subject{"zhou-kadanoff-1996-three-balls", few},
                              Subject{"dolmaire-velazquez-2024-three-spheres", few},
                              Subject{"schorghofer-zhou-1996-triple", few},
                              Subject{"schorghofer-zhou-1996-rotating-triple", few},
                              Subject{"cornell-swift-bray-1998-random-acceleration", few},
                              Subject{"haff-1983-cooling", cooling},
                              Subject{"mcnamara-young-1992-1d-cooling", cooling},
                              Subject{"mcnamara-young-1994-2d-cooling", cooling},
                              Subject{"deltour-barrat-1997-rotation-2d-cooling", cooling},
                              Subject{"brilliantov-poeschel-2000-viscoelastic-cooling", cooling},
                              Subject{"rough-cooling", cooling},
                              Subject{"van-noije-1999-2d-random-driving", driven},
                              Subject{"kachuck-voth-2013-vibrated-column", driven},
                              Subject{"alam-hrenya-2001-2d-shear", driven},
                              Subject{"binary-shear", driven},
                              Subject{"kikuchi-2026-two-valued-shear", driven},
                              Subject{"luding-mcnamara-1998-tc-shear", driven},
                              Subject{"rough-walls-2d-shear", driven},
                              Subject{"bumpy-walls", driven}};

std::string_view heading_of(std::string_view name) {
  if (name.starts_with("sweeps/")) return sweeps;
  const auto found = std::find_if(subjects.begin(), subjects.end(),
                                  [&](const Subject& one) { return one.name == name; });
  return found == subjects.end() ? others : found->heading;
}

/// In the order of `subjects`, and behind them in that of their names.
bool comes_before(const ShippedCase& one, const ShippedCase& other) {
  const auto place = [](const ShippedCase& shipped) {
    return std::find_if(subjects.begin(), subjects.end(),
                        [&](const Subject& each) { return each.name == shipped.name; });
  };
  return place(one) < place(other);
}

/// Whether what ends at `end` is cut short there, as Phys. and Rev. are: no sentence ends in a word
/// that begins with a capital.
bool is_abbreviation(const std::string& text, std::size_t end) {
  if (text[end] != '.') return false;
  const std::size_t blank = text.find_last_of(' ', end);
  const std::size_t begin = blank == std::string::npos ? 0 : blank + 1;
  return text[begin] >= 'A' && text[begin] <= 'Z';
}

}  // namespace

std::vector<ExampleGroup> example_groups() {
  std::vector<ExampleGroup> groups;
  for (const std::string_view heading : {paper, few, cooling, driven, others, sweeps}) {
    ExampleGroup group{heading};
    for (const ShippedCase& shipped : shipped_cases()) {
      const bool is_question = shipped.name.starts_with("new/");
      if (!is_question && heading_of(shipped.name) == heading) group.cases.push_back(shipped);
    }
    std::stable_sort(group.cases.begin(), group.cases.end(), comes_before);
    if (!group.cases.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

std::string title_of(const ShippedCase& shipped) {
  std::string title;
  std::string_view rest = shipped.text;
  while (rest.starts_with("# ")) {
    const std::string_view line = rest.substr(2, rest.find('\n') - 2);
    title += (title.empty() ? "" : " ") + std::string(line);
    rest.remove_prefix(rest.find('\n') + 1);
  }
  for (std::size_t n = 0; n + 1 < title.size(); ++n) {
    const bool ends = title[n] == '.' || title[n] == '?' || title[n] == ':';
    if (!ends || title[n + 1] != ' ' || is_abbreviation(title, n)) continue;
    return title.substr(0, n + (title[n] == '?' ? 1 : 0));
  }
  return title;
}

}  // namespace zenosphere
