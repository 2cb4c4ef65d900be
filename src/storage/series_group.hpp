#pragma once

#include "storage/hdf5.hpp"
#include "storage/records.hpp"

namespace zenosphere {

/// Writes the time series of a run to /zenosphere/series, in the place of one that is there; and
/// to /observables, for each snapshot, the averages over the interval in which it lies.
///
/// H5MD's /observables may have times of their own, but readers that go from frame to frame
/// (MDAnalysis) take row n for frame n: so they have those of the snapshots.
void write_series(const hdf5::Handle& file, const RecordedSeries& series);

/// Writes what a run has accumulated to /zenosphere/samples, in the place of what is there; nothing
/// where it accumulates nothing.
void write_samples(const hdf5::Handle& file, const RecordedSamples& samples);

/// What a file holds of it; empty where it holds nothing. Throws hdf5::Error.
RecordedSamples read_samples(const hdf5::Handle& file);

/// The series that a file holds; without rows where it holds none. Throws hdf5::Error.
RecordedSeries read_series(const hdf5::Handle& file);

}  // namespace zenosphere
