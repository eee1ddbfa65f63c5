#include "topology/meshing/mesher.h"

#include <algorithm>

namespace topology {

double MesherOptions::limited(double wanted, const FlatPoint& at) const
{
    if (size > 0.0) wanted = std::min(wanted, size);
    return field ? std::min(wanted, field->at(at)) : wanted;
}

CellMesh Mesher::run(const std::function<bool()>& is_cancelled)
{
    constexpr std::size_t between_looks = 256;
    for (std::size_t i = 0; next() != Step::Done; ++i)
        if (i % between_looks == 0 && is_cancelled && is_cancelled()) break;
    return mesh();
}

} // namespace topology
