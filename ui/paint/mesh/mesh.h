#pragma once

#include "ui/paint/geometry.h"

#include <cstdint>
#include <vector>

namespace ui {

/// Triangles of one colour in PHYSICAL pixels, with edges that are soft over one pixel instead of jagged.
///
/// A vertex carries its `coverage`, interpolated over the triangle. Vertices of lines and discs carry besides how far
/// they lie from the middle and how far the shape reaches, both in pixels; the renderer then multiplies the coverage
/// by clamp(reach - |across|, 0, 1), so a line needs two triangles a segment and no border of its own.
struct Mesh {
    struct Vertex {
        float x;
        float y;
        float coverage;
        float across; ///< signed distance from the middle
        float reach;  ///< distance at which nothing is left; 0: coverage alone counts
    };

    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices; ///< three a triangle

    void clear()
    {
        vertices.clear();
        indices.clear();
    }
    std::uint32_t add(Point p, double coverage, double across = 0.0, double reach = 0.0)
    {
        vertices.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(coverage),
                            static_cast<float>(across), static_cast<float>(reach)});
        return static_cast<std::uint32_t>(vertices.size() - 1);
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { indices.insert(indices.end(), {a, b, c}); }
    void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
    {
        triangle(a, b, c);
        triangle(a, c, d);
    }
    std::size_t n_triangles() const { return indices.size() / 3; }
    /// What a pixel whose middle is p would show: the coverages of the triangles it lies in, laid over one another.
    double coverage_at(Point p) const;
};

} // namespace ui
