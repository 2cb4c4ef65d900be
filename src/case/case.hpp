#pragma once

#include <string>
#include <vector>

#include "case/tables/collapse.hpp"
#include "case/tables/collision.hpp"
#include "case/tables/drive.hpp"
#include "case/tables/gravity.hpp"
#include "case/tables/measure.hpp"
#include "case/tables/output.hpp"
#include "case/tables/polydispersity.hpp"
#include "case/tables/run.hpp"
#include "case/tables/species.hpp"
#include "case/tables/start.hpp"
#include "case/tables/system.hpp"
#include "case/tables/walls.hpp"

namespace zenosphere {

/// One run as its user describes it: the resolved content of a case file.
///
/// Lengths are in sphere diameters, masses in sphere masses, times in the case's own unit; where
/// there are species, in the units in which their diameters and masses are given.
/// The members mirror the tables and keys of the file; docs/case-file.md tells what each means.
struct Case {
  using Walls = case_format::Walls;
  using Output = case_format::Output;

  case_format::System system;
  std::vector<Species> species{};          ///< empty: unit spheres of one kind
  std::vector<SpeciesContact> contacts{};  ///< no two of the same pair
  case_format::Polydispersity polydispersity;
  case_format::Start start;
  case_format::Drive drive;
  Walls walls;
  case_format::Gravity gravity;
  case_format::Collisions collision;
  case_format::Collapse collapse;
  case_format::Run run;
  case_format::Measure measure;
  Output output;

  std::string text;  ///< the file as it was read, byte for byte

  /// Calls visit(name, table) for each table but [[species]] and [[contact]], in the order of the
  /// reference page.
  template <class Visitor>
  void tables(Visitor&& visit) {
    visit("system", system);
    visit("start", start);
    visit("drive", drive);
    visit("walls", walls);
    visit("gravity", gravity);
    visit("collision", collision);
    visit("polydispersity", polydispersity);
    visit("collapse", collapse);
    visit("run", run);
    visit("measure", measure);
    visit("output", output);
  }
};

}  // namespace zenosphere
