#pragma once

#include <cstddef>
#include <vector>

#include "topology/meshing/mesh_domain.h"

namespace topology {

/// Whether places are inside a domain: on how many sides of a place edges pass by. Edges are listed by bands of height,
/// so that a place asks those alone that may be as high as it is.
class InsideTest {
public:
    explicit InsideTest(const MeshDomain& domain);
    /// \pre the place is on no edge
    bool has_inside(const FlatPoint& at) const;

private:
    struct Edge {
        FlatPoint a, b;
    };
    std::size_t band_of(double y) const;

    double low_ = 0.0, bands_per_height_ = 0.0;
    std::vector<std::vector<Edge>> bands_;
};

} // namespace topology
