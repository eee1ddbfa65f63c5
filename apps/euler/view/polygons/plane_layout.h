#pragma once

#include "apps/euler/view/subject.h"
#include "ui/canvas/plane_camera.h"
#include "ui/paint/geometry.h"

#include <optional>
#include <span>
#include <vector>

namespace euler {

/// Where a loop of a plane model is drawn: a regular polygon, or a circle where it has one half-edge or two.
struct Polygon {
    ui::World2 middle;
    double radius = 1.0;
    int n = 0;            ///< of half-edges; 0 of a lone vertex
    bool is_ring = false; ///< runs clockwise, its face around it

    /// At side i and a share of it, on the polygon `factor` times as large.
    ui::World2 at(int i, double share, double factor = 1.0) const;
    double inner_radius() const;
    int n_points() const; ///< that draw a side

private:
    ui::World2 on_circle(double i, double factor) const;
};

/// Where all polygons of solids stand: the faces one after another in rows, in each its rings.
class PlaneLayout {
public:
    explicit PlaneLayout(std::span<const Subject> subjects);

    struct Face {
        topology::FaceId face;
        Polygon outline;                     ///< a circle without sides about a lone vertex
        std::vector<topology::LoopId> loops; ///< the outer one first
    };
    const std::vector<Face>& faces(std::size_t subject) const { return solids_[subject].faces; }
    const Polygon& polygon(std::size_t subject, topology::LoopId loop) const
    {
        return solids_[subject].polygons[loop.index];
    }
    /// The place of a half-edge in its loop; nothing where the solid has it not.
    std::optional<int> side(std::size_t subject, topology::HalfEdgeId h) const;
    const topology::Solid& solid(std::size_t subject) const { return *solids_[subject].solid; }
    bool has(std::size_t subject) const { return subject < solids_.size(); }
    const ui::Box& bounds() const { return bounds_; } ///< in the model's plane

private:
    struct Solid {
        const topology::Solid* solid;
        std::vector<Face> faces{};
        std::vector<Polygon> polygons{}; ///< by loop
        std::vector<int> sides{};        ///< by half-edge
    };
    struct Place {
        ui::World2 middle;
        double radius;
    };
    static std::vector<Place> face_places(std::span<const Subject> subjects);
    static Place ring_place(const Place& room, std::size_t k, std::size_t n);
    static void add(Solid& to, topology::FaceId f, const Place& place);

    std::vector<Solid> solids_;
    ui::Box bounds_{};
};

/// Where a plane model stands on the way between two states of its solids: those that are drawn, and the same before
/// the step or after it. Each side moves from the one polygon to the other; one that only the drawn solid has comes out
/// of what joins its neighbours there, a chord across the polygon or a point.
class PlaneOnItsWay {
public:
    /// \param share  of the drawn solids' own places: 1 at rest, 0 where the others stand. \pre drawn and other outlive
    PlaneOnItsWay(const PlaneLayout& drawn, const PlaneLayout* other, double share)
        : drawn_(drawn), other_(other), share_(other == nullptr ? 1.0 : share)
    {}

    bool rests() const { return share_ >= 1.0; }
    /// Of a side, so far inside its face: `aside` is a share of the polygon's size.
    ui::World2 at(std::size_t subject, topology::HalfEdgeId h, double share_of_side, double aside = 0.0) const;
    /// That draw a side: one where it is straight, as it stays on its way from one straight place to another.
    int n_points(std::size_t subject, topology::HalfEdgeId h) const;

private:
    ui::World2 there(std::size_t subject, topology::HalfEdgeId h, double t, double aside) const;
    std::optional<ui::World2> neighbour(std::size_t subject, topology::HalfEdgeId h, bool is_next, double aside) const;
    std::optional<ui::World2> old_vertex(std::size_t subject, topology::HalfEdgeId h, double aside) const;

    const PlaneLayout& drawn_;
    const PlaneLayout* other_;
    double share_;
};

} // namespace euler
