#pragma once

#include "ui/paint/geometry.h"
#include "ui/paint/label/oriented_box.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ui {

/// Whether labels may never cover it, or may where there is no other place for them.
enum class Firmness { Hard, Soft };
/// What a box would cover: nothing, something soft at most, or something hard.
enum class Ground : std::uint8_t { Free, Soft, Taken };

/// What labels have to keep clear of. Answers what a box would cover, through a grid of cells.
class LabelObstacles {
public:
    explicit LabelObstacles(const Box& room);

    void add_segment(Point a, Point b, double width = 0.0, Firmness firmness = Firmness::Hard);
    void add_polyline(std::span<const Point> points, double width = 0.0, Firmness firmness = Firmness::Hard);
    /// Its area and its outline.
    void add_polygon(std::span<const Point> points, Firmness firmness = Firmness::Hard);
    /// Its area alone: its outline is added as lines.
    void add_inside(std::span<const Point> points, Firmness firmness);
    void add_box(const Box& box, Firmness firmness = Firmness::Hard);
    /// Taken as the square around it.
    void add_disc(Point center, double radius, Firmness firmness = Firmness::Hard);

    Ground ground_of(const OrientedBox& box) const;
    /// What lies at a point, of the polygons' insides alone.
    Ground ground_inside(Point p) const;

private:
    friend class ObstacleMap;

    struct Segment {
        Point a;
        Point b;
        double half_width;
        Firmness firmness;
        Box bounds;
    };
    struct Polygon {
        std::size_t begin; ///< of its corners
        std::size_t count;
        Box bounds;
        Firmness firmness;
    };
    struct Cell {
        std::vector<std::uint32_t> segments;
        std::vector<std::uint32_t> polygons;
    };
    struct CellRange {
        int x0, y0, x1, y1;
    };

    CellRange cells(const Box& box) const;
    Cell& cell(int x, int y) { return cells_[static_cast<std::size_t>(y * n_columns_ + x)]; }
    const Cell& cell(int x, int y) const { return cells_[static_cast<std::size_t>(y * n_columns_ + x)]; }
    bool contains(const Polygon& polygon, Point p) const;

    Box room_;
    int n_columns_;
    int n_rows_;
    std::vector<Cell> cells_;
    std::vector<Segment> segments_;
    std::vector<Polygon> polygons_;
    std::vector<Point> corners_;
};

} // namespace ui
