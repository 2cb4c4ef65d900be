#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "export/frame.hpp"
#include "storage/atomic_file.hpp"
#include "storage/new_file.hpp"

namespace zenosphere {

/// Writes a frame as VTK XML PolyData (.vtp), which ParaView, VTK and OVITO read.
///
/// Points are the positions in the upright box, each a vertex; point data: id (the sphere, from 0),
/// velocity, radius and, where known, collisions. Field data: TimeValue, step, the cell (its three
/// vectors, one a row) and its origin. All numbers as they are in the output file, in base64.
/// Source: https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
void write_vtk_frame(NewFile& file, const Frame& frame);

/// `frame-000012.vtp`: the file of a snapshot.
std::filesystem::path vtk_frame_name(std::int64_t number);

/// A folder of such files, and of no others.
FolderOf folder_of_vtk_frames();

/// A file that a collection lists.
struct TimedFile {
  double time = 0;
  std::filesystem::path path;  ///< from the folder of the collection
};

/// A ParaView collection (.pvd): which file shows which time.
std::string vtk_collection(const std::vector<TimedFile>& files);

}  // namespace zenosphere
