#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "topology/planar/planar_subdivision.h"

namespace cli {

/// Random straight lines in a square of 2^20: from anywhere to anywhere, or to within 20000 along x and y.
/// Source  the numbers are splitmix64's: [Steele2014]
struct RegionLines {
    std::size_t n = 1000;
    bool is_long = true;
    std::uint64_t seed = 1;
};

/// Those lines; without any whose ends are one.
std::vector<topology::Segment> segments_of(const RegionLines& lines);

/// What `cremona bench regions` finds, and what it takes to insert the lines one after the other, in seconds.
struct RegionBench {
    topology::PlanarCounts counts;
    double seconds = 0.0, slowest_insertion = 0.0;
};
/// \param one_by_one  the number of regions is asked for after every line
RegionBench bench_regions(const RegionLines& lines, bool one_by_one);

} // namespace cli
