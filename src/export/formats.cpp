#include "export/formats.hpp"

#include <algorithm>
#include <array>

#include "export/tables.hpp"

namespace zenosphere {

// Formats of a frame after the other, each in a source of its own.
ExportFormat extended_xyz();
ExportFormat lammps_dump();

std::span<const ExportFormat> export_formats() {
  static const std::array formats{extended_xyz(),
                                  lammps_dump(),
                                  ExportFormat{"vtp", "ParaView: NAME.pvd and a folder of frames",
                                               Exports::collection_of_frames, true},
                                  ExportFormat{"csv-observables", "", Exports::frames, false,
                                               append_observables, observables_header},
                                  ExportFormat{"csv-collisions", "", Exports::collisions},
                                  ExportFormat{"csv-series", "tables", Exports::series}};
  return formats;
}

const ExportFormat* export_format(std::string_view word) {
  const auto formats = export_formats();
  const auto found = std::ranges::find(formats, word, &ExportFormat::word);
  return found == formats.end() ? nullptr : &*found;
}

}  // namespace zenosphere
