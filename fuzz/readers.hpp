#pragma once

#include <cstdint>
#include <span>

/// One function for each reader of what may come from somebody else. Each takes any bytes, lets the
/// reader refuse them with an InputError, and ends the process where something else happens.
namespace zenosphere::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// A case file; behind each zero byte one argument of `--set`. What is accepted must survive being
/// written and read again. Files that a case names are not opened.
void case_file(Bytes bytes);

/// A sweep file that holds its base case itself, as one that names a file is not followed. The base
/// case that its store would keep must make the same first run.
void sweep_file(Bytes bytes);

/// The JSON text in /zenosphere/summary. What is accepted must survive being written and read.
void summary(Bytes bytes);

/// A start in extended XYZ, of two spheres in one, two and three dimensions.
void start_text(Bytes bytes);

/// A start in HDF5, of three spheres in two dimensions.
void start_output(Bytes bytes);

/// An output file, as `info` prints it.
void output_file(Bytes bytes);

/// An output file, as `verify` reads it: all of it.
void verified_file(Bytes bytes);

/// A journal. The first byte says whether it is taken as it is or made whole first: then what
/// follows are records of a kind (one byte), a length (two bytes) and a payload each, whose
/// checksums are made right, since nothing gets past them otherwise.
void journal(Bytes bytes);

/// The state in a checkpoint, of one of five small runs by the first byte, and the run's next
/// collisions: what it refuses to read it must not do, what it reads it must be able to go on from.
void checkpoint(Bytes bytes);

}  // namespace zenosphere::fuzz
