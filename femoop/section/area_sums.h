#pragma once

#include <numbers>

namespace femoop {

/// Integrals over a figure that is added up from rectangles and rounded corners with sides along y and z; exact.
///
///     y ^   +----.        a rounded corner: what lies between two sides that meet at a right angle and the arc of
///       |   |   . .       radius r that touches both; it is added at a fillet and taken away (times -1) at an edge
///       o---> z
struct AreaSums {
    double A = 0.0;
    double y = 0.0, z = 0.0;             ///< integrals of y, z
    double yy = 0.0, zz = 0.0, yz = 0.0; ///< integrals of y^2, z^2, y z

    struct Range {
        double from, to;
    };
    constexpr void add_rectangle(Range in_y, Range in_z, double times = 1.0)
    {
        const auto power = [](Range r, int n) {
            double from = 1.0, to = 1.0;
            for (int i = 0; i < n; ++i) {
                from *= r.from;
                to *= r.to;
            }
            return (to - from) / n;
        };
        A += times * power(in_y, 1) * power(in_z, 1);
        y += times * power(in_y, 2) * power(in_z, 1);
        z += times * power(in_y, 1) * power(in_z, 2);
        yy += times * power(in_y, 3) * power(in_z, 1);
        zz += times * power(in_y, 1) * power(in_z, 3);
        yz += times * power(in_y, 2) * power(in_z, 2);
    }

    /// Where the sides meet, and to which side of that point the figure lies along each axis: 1 or -1.
    struct Corner {
        double y, z;
        double along_y, along_z;
    };
    constexpr void add_rounded_corner(const Corner& at, double r, double times = 1.0)
    {
        constexpr double quarter_pi = std::numbers::pi / 4.0;
        const double area = (1.0 - quarter_pi) * r * r;
        const double first = (5.0 / 6.0 - quarter_pi) * r * r * r; // about either side
        const double second = (1.0 - 1.25 * quarter_pi) * r * r * r * r;
        const double product = (19.0 / 24.0 - quarter_pi) * r * r * r * r;
        const double first_y = at.along_y * first, first_z = at.along_z * first;
        A += times * area;
        y += times * (area * at.y + first_y);
        z += times * (area * at.z + first_z);
        yy += times * (area * at.y * at.y + 2.0 * at.y * first_y + second);
        zz += times * (area * at.z * at.z + 2.0 * at.z * first_z + second);
        yz += times * (area * at.y * at.z + at.y * first_z + at.z * first_y + at.along_y * at.along_z * product);
    }

    constexpr double centroid_y() const { return y / A; }
    constexpr double centroid_z() const { return z / A; }
    constexpr double Iz() const { return yy - y * y / A; }  ///< of y^2, about the centroid
    constexpr double Iy() const { return zz - z * z / A; }  ///< of z^2
    constexpr double Iyz() const { return yz - y * z / A; } ///< of y z
};

} // namespace femoop
