#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

/// Area moments of a plane figure from its outline alone, by Green's theorem: exact for straight edges.
/// Counter-clockwise (z to the right, y up) counts positive; a hole runs clockwise.
struct AreaMoments {
    double A = 0.0, Sy = 0.0, Sz = 0.0, Iyy = 0.0, Izz = 0.0, Iyz = 0.0; ///< integrals of 1, y, z, y^2, z^2, y z

    double y() const { return Sy / A; }
    double z() const { return Sz / A; }
    double about_centroid_yy() const { return Iyy - A * y() * y(); }
    double about_centroid_zz() const { return Izz - A * z() * z(); }
    double about_centroid_yz() const { return Iyz - A * y() * z(); }
};

struct OutlinePoint {
    double z, y;
};

inline AreaMoments area_moments(const std::vector<OutlinePoint>& outline, AreaMoments m = {})
{
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto [z1, y1] = outline[i];
        const auto [z2, y2] = outline[(i + 1) % outline.size()];
        const double cross = z1 * y2 - z2 * y1;
        m.A += cross / 2.0;
        m.Sy += cross * (y1 + y2) / 6.0;
        m.Sz += cross * (z1 + z2) / 6.0;
        m.Iyy += cross * (y1 * y1 + y1 * y2 + y2 * y2) / 12.0;
        m.Izz += cross * (z1 * z1 + z1 * z2 + z2 * z2) / 12.0;
        m.Iyz += cross * (2.0 * z1 * y1 + z1 * y2 + z2 * y1 + 2.0 * z2 * y2) / 24.0;
    }
    return m;
}
