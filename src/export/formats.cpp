#include "export/formats.hpp"

#include <algorithm>
#include <array>

#include "export/extended_xyz_frame.hpp"
#include "export/lammps_dump.hpp"
#include "export/tables.hpp"

namespace zenosphere {

std::span<const ExportFormat> export_formats() {
  static constexpr std::array formats{
      ExportFormat{"extxyz", "OVITO, ASE", Exports::frames, true, append_extended_xyz},
      ExportFormat{"lammps", "OVITO, VMD, MDAnalysis, ASE", Exports::frames, true,
                   append_lammps_dump},
      ExportFormat{"vtp", "ParaView: NAME.pvd and a folder of frames",
                   Exports::collection_of_frames, true},
      ExportFormat{"csv-observables", "", Exports::frames, false, append_observables,
                   observables_header},
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
