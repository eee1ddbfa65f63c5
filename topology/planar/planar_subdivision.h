#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "topology/geometry/curve.h"
#include "topology/halfedge/operators/euler_operator.h"
#include "topology/planar/edge_grid.h"

namespace topology {

/// A curve that was put into a subdivision, counted from 0.
using CurveIndex = std::uint32_t;

/// A part of a curve.
struct CurvePart {
    CurveIndex curve = 0;
    Span span; ///< as the edge's plus half runs

    friend bool operator==(const CurvePart&, const CurvePart&) = default;
};

/// How many there are. They obey V - E + F = 1 + C, with F = regions + 1.
struct PlanarCounts {
    std::size_t vertices = 0, edges = 0, regions = 0, components = 0;
    std::size_t dangling = 0; ///< edges with the same face on both sides

    friend bool operator==(const PlanarCounts&, const PlanarCounts&) = default;
};

/// Why a curve is not put in; nothing has changed then.
struct InsertionRefusal {
    /// The one in the subdivision that it lies on along a stretch, where the two are neither straight nor of one
    /// circle. Nothing: it comes so close to others, again and again, that what lies on which side of it is lost in snap.
    std::optional<CurveIndex> runs_along;
};

/// The plane as curves divide it into vertices, edges and regions. Curves may cross each other, touch, overlap and end
/// anywhere; the result does not depend on their order.
///
/// Tolerance  places closer than `snap` are one vertex, and a vertex closer than that to an edge lies on it; so no edge
///            is shorter, and predicates, which are as exact as doubles are, meet nothing finer
/// Method     each curve is cut where it meets what is there; cuts become vertices by SEMV and MVR, its pieces edges by
///            MEV, MEF and MEKR, and rings move to new faces by RINGMV. Nothing else changes the solid, so that
///            `undo` is exact
/// Source     [Mantyla1988]; the insertion follows [Cavalcanti1997]
class PlanarSubdivision {
public:
    explicit PlanarSubdivision(double snap) : snap_(snap) {} ///< \pre > 0

    /// A vertex of its own, or on what is there. Its handle.
    VertexId insert(const FlatPoint& point);
    /// \param ends  where it begins and ends, exactly: as the drawing gives them
    /// \pre it is longer than snap, and does not run back along itself
    std::optional<InsertionRefusal> insert(const Curve& curve, const std::array<FlatPoint, 2>& ends);
    void undo(); ///< the last insertion. \pre there was one
    std::size_t n_insertions() const { return marks_.size(); }

    const Solid& solid() const { return solid_; }
    double snap() const { return snap_; }
    PlanarCounts counts() const;
    std::size_t n_regions() const ///< as counts, without a look at all
    {
        return solid_.is_empty() ? 0 : solid_.faces().n_living() - 1;
    }

    FlatPoint at(VertexId v) const { return {solid_.point(v).x, solid_.point(v).y}; }
    const Curve& curve(CurveIndex i) const { return curves_[i]; }
    std::size_t n_curves() const { return curves_.size(); }
    const CurvePart& part(EdgeId e) const { return parts_[e.index]; } ///< that gives the edge its shape
    /// All that run along the edge, that one first.
    std::vector<CurvePart> carriers(EdgeId e) const;
    /// The curve along a half-edge, as it runs.
    Span span(HalfEdgeId h) const;

    /// The face that is not bounded. \pre there is a vertex
    FaceId unbounded() const { return unbounded_; }
    FaceId face_at(const FlatPoint& p) const;                ///< \pre it lies on no edge, and there is a vertex
    std::optional<EdgeId> edge_at(const FlatPoint& p) const; ///< that it lies on, to within snap
    /// Of the corner before the half-edge, inside its face: 0 where two edges touch, 2 pi at a free end.
    double corner_angle(HalfEdgeId h) const;

    double area(LoopId l) const;            ///< positive where it runs counter-clockwise
    double area(FaceId f) const;            ///< less what is inside its holes
    double perimeter(FaceId f) const;       ///< with its holes', without edges that dangle in it
    std::size_t n_holes(FaceId f) const;    ///< loops inside it that go around something
    FlatPoint place_inside(FaceId f) const; ///< well away from its edges. \pre bounded

private:
    friend class CurveInsertion;
    /// A piece that comes so close to others that its side of them is lost in snap.
    struct Tangled : std::runtime_error {
        Tangled() : std::runtime_error("curves closer than snap") {}
    };
    /// What an insertion began with.
    struct Mark {
        std::size_t n_steps = 0, n_curves = 0, n_changes = 0;
    };
    /// What a part or the other carriers of an edge were.
    struct Change {
        EdgeId edge;
        CurvePart part;
        std::vector<CurvePart> others;
    };

    static constexpr CurveIndex no_curve = std::numeric_limits<CurveIndex>::max();
    /// A piece of a curve from one vertex to another: a straight one, or one of no curve, runs between the vertices,
    /// wherever those are.
    struct Piece {
        CurvePart part;
        FlatPoint from, to;
    };

    void begin();
    void insert_parts(const std::array<FlatPoint, 2>& ends);
    VertexId lone_vertex(const FlatPoint& at);
    VertexId split(EdgeId e, double t, const FlatPoint& at);
    VertexId grow(VertexId from, const FlatPoint& to, const CurvePart& along);
    EdgeId connect(VertexId from, VertexId to, const CurvePart& along);
    EdgeId close(VertexId v, const CurvePart& along);
    void carry(HalfEdgeId along, const CurvePart& part);
    std::optional<HalfEdgeId> same_edge(const Piece& piece, VertexId from, VertexId to) const;
    EdgeId split_face(HalfEdgeId from, HalfEdgeId to, const Piece& piece);
    /// Areas of the loops on both sides of a piece that splits one; that of the longer one as far as it was walked.
    struct Sides {
        double left = 0.0, right = 0.0;
        double sliver = 0.0; ///< what is less may be nothing
        bool is_left_shorter = false, is_other_known = false;
    };
    Sides sides(HalfEdgeId from, HalfEdgeId to, const Piece& piece) const;
    bool is_new_face_left(HalfEdgeId from, HalfEdgeId to, const Piece& piece) const;
    void move_rings(const NewFace& made);
    void make_outer(LoopId ring);
    void remove(EdgeId e);
    void reroute(EdgeId e, double t, VertexId through);

    void set(EdgeId e, VertexId from, const CurvePart& part);
    void change(EdgeId e);
    void add_to_grid(EdgeId e);
    void fit_grid(const FlatBox& box);
    Piece piece(HalfEdgeId h) const { return {{part_of(h).curve, span(h)}, at(solid_.start(h)), at(solid_.end(h))}; }
    bool is_straight(const CurvePart& part) const
    {
        return part.curve == no_curve || curves_[part.curve].is_straight();
    }
    bool is_straight(const Piece& piece) const; ///< or as short as a few times snap
    FlatPoint place(const Piece& piece, double share) const;
    FlatVector direction(const Piece& piece) const;
    double extent(const Piece& piece) const;
    double angle_between(const Piece& a, const Piece& b) const;
    HalfEdgeId corner(VertexId v, const Piece& leaving) const;
    const CurvePart& part_of(HalfEdgeId h) const { return parts_[solid_.edge(h)->index]; }

    double area(const Piece& piece, const FlatPoint& origin) const;
    /// Calls cross(x, whether upwards) wherever the half-edge crosses the height, each end's own height counted once.
    template <class Cross> void at_height(HalfEdgeId h, double y, const Cross& cross) const;
    VertexId seen_from(const FlatPoint& p, VertexId v) const;
    /// Where a level line to the right meets an edge, whose half-edge here has its face before the place.
    struct Crossing {
        double x = 0.0;
        HalfEdgeId before;
    };
    HalfEdgeId first_of(const std::vector<Crossing>& met) const;
    bool encloses(LoopId l, const FlatPoint& p) const;
    bool has_area(LoopId l) const;

    double snap_;
    Solid solid_;
    Journal journal_;
    std::vector<Curve> curves_;
    std::vector<CurvePart> parts_;                              ///< by edge
    std::unordered_map<EdgeId, std::vector<CurvePart>> others_; ///< where several run along one edge
    std::vector<Change> changes_;
    std::vector<Mark> marks_;
    FaceId unbounded_;
    EdgeGrid edges_, points_;             ///< where edges are, and vertices that were alone when they were made
    std::vector<VertexId> lone_vertices_; ///< those vertices, and some that are no more
    std::size_t n_changes_in_grid_ = 0;   ///< older than its cells
    std::size_t n_expected_ = 64;
    std::vector<bool> is_seen_edge_, is_seen_vertex_; ///< of an insertion that gathers what is near; all false between
};

} // namespace topology
