#pragma once

#include <cstddef>
#include <vector>

namespace bench {

struct FrameSize {
    std::size_t bays = 1, storeys = 1;
    std::size_t n_unknowns() const { return 3 * (bays + 1) * storeys; }
};

/// The matrix of the frame of `cremona bench frame`, lower triangle by columns, degree of freedom by degree of freedom
/// in the order of the nodes; written without our library.
struct System {
    std::vector<int> start, rows;
    std::vector<double> values;
    std::vector<double> f;
    std::size_t top_left = 0; ///< ux of the top left node
};

System plane_frame_system(FrameSize size);

/// What a solver needs by itself for that system: seconds and megabytes.
struct Reference {
    double analyse = 0.0, factor = 0.0, solve = 0.0;
    double peak_mb = 0.0; ///< of a process that does nothing else
    double sway = 0.0;    ///< ux of the top left node [m], to know that it is the same system
    double total() const { return analyse + factor + solve; }
};

/// Each runs in a process of its own, so that its peak is its own.
Reference cholmod_amd(FrameSize size);
Reference cholmod_metis(FrameSize size);
Reference mumps(FrameSize size); ///< with METIS

} // namespace bench
