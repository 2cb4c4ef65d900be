#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "export/frame.hpp"
#include "export/new_file.hpp"

namespace zenosphere {

/// Writes a frame as VTK XML PolyData (.vtp), which ParaView, VTK and OVITO read.
///
/// Points are the positions in the upright box, each a vertex; point data: id (the sphere, from 0),
/// velocity, radius and, where known, collisions. Field data: TimeValue, step, the cell (its three
/// vectors, one a row) and its origin. All numbers as they are in the output file, in base64.
/// Source: https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
void write_vtk_frame(NewFile& file, const Frame& frame);

/// A file that a collection lists.
struct TimedFile {
  double time = 0;
  std::filesystem::path path;  ///< from the folder of the collection
};

/// A ParaView collection (.pvd): which file shows which time.
std::string vtk_collection(const std::vector<TimedFile>& files);

}  // namespace zenosphere
