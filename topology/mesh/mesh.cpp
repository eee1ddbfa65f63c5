#include "topology/mesh/mesh.h"

#include <limits>
#include <unordered_map>

#include "topology/geometry/vector.h"
#include "topology/halfedge/check/validate.h"
#include "topology/halfedge/operators/euler_operator.h"
#include "topology/mesh/assembly.h"

namespace topology {

std::string_view pattern(MeshFault fault)
{
    switch (fault) {
    case MeshFault::BadNumber: return "\"{0}\" is no finite number";
    case MeshFault::BadIndex: return "\"{0}\" is not the number of a point";
    case MeshFault::NoHeader: return "the file does not begin with OFF";
    case MeshFault::TooFewWords: return "the line is too short";
    case MeshFault::TooShort: return "face {0} has fewer than three points";
    case MeshFault::NoPolygons: return "there is no face";
    case MeshFault::CutOff: return "the file ends before the points and faces that it announces";
    case MeshFault::SameDirection:
        return "the edge from point {0} to point {1} runs the same way in two faces; "
               "turn one of them over, or there are more than two faces at the edge";
    case MeshFault::OpenEdge: return "the surface is open at the edge from point {0} to point {1}; a solid's is closed";
    case MeshFault::PinchedPoint: return "the surface meets itself at point {0}; separate the two parts there";
    }
    return "";
}

LineError error(MeshFault fault, const std::vector<std::string>& words) { return {pattern(fault), words}; }

namespace {

/// Points as the file numbers them, from 1.
std::string numbered(std::uint32_t point) { return std::to_string(std::size_t{point} + 1); }

std::uint64_t key(std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32U | to; }

/// The tables of the surface, row by row.
Tables tables_of(const Mesh& mesh, std::vector<std::uint32_t>& point_of)
{
    Tables t;
    std::vector<VertexId> vertices(mesh.points.size(), nothing<VertexId>);
    std::unordered_map<std::uint64_t, HalfEdgeId> halves;
    for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
        const std::vector<std::uint32_t>& polygon = mesh.polygons[i];
        if (polygon.size() < 3) throw error(MeshFault::TooShort, {std::to_string(i + 1)});
        const auto first = static_cast<std::uint32_t>(t.half_edges.n_rows()),
                   n = static_cast<std::uint32_t>(polygon.size());
        const LoopId l{static_cast<std::uint32_t>(i)};
        for (std::uint32_t k = 0; k < n; ++k) {
            const std::uint32_t from = polygon[k], to = polygon[(k + 1) % n];
            if (vertices[from] == nothing<VertexId>) {
                vertices[from] = t.vertices.add({HalfEdgeId{first + k}, mesh.points[from]});
                point_of.push_back(from);
            }
            const HalfEdgeId h = t.half_edges.add({vertices[from], nothing<EdgeId>, l, HalfEdgeId{first + (k + 1) % n},
                                                   HalfEdgeId{first + (k + n - 1) % n}});
            if (!halves.emplace(key(from, to), h).second)
                throw error(MeshFault::SameDirection, {numbered(from), numbered(to)});
            const auto mate = halves.find(key(to, from));
            if (mate == halves.end() || mate->second == h) continue;
            const EdgeId e = t.edges.add({h, mate->second});
            t.half_edges[h].edge = t.half_edges[mate->second].edge = e;
        }
        t.loops.add({HalfEdgeId{first}, FaceId{l.index}, l, l});
        t.faces.add({l});
    }
    return t;
}

void require_closed(const Tables& t, const std::vector<std::uint32_t>& point_of)
{
    for (const HalfEdgeId h : t.half_edges)
        if (t.is_lone(h))
            throw error(MeshFault::OpenEdge,
                        {numbered(point_of[t.start(h).index]), numbered(point_of[t.start(t.next(h)).index])});
}

} // namespace

Solid solid_of(const Mesh& mesh)
{
    if (mesh.polygons.empty()) throw error(MeshFault::NoPolygons, {});
    std::vector<std::uint32_t> point_of; // by vertex
    const Assembly assembly(tables_of(mesh, point_of));
    require_closed(assembly.solid().tables(), point_of);
    if (const auto breach = why_not_valid(assembly.solid()))
        throw error(MeshFault::PinchedPoint, {numbered(point_of[breach->entities[1].index])});
    return assembly.solid();
}

namespace {

struct Corners {
    HalfEdgeId outer, ring;
};

Corners nearest(const Solid& solid, LoopId outer, LoopId ring)
{
    Corners best{};
    double least = std::numeric_limits<double>::infinity();
    for (const HalfEdgeId a : solid.chain(outer))
        for (const HalfEdgeId b : solid.chain(ring)) {
            const double distance = length(solid.point(solid.start(a)) - solid.point(solid.start(b)));
            if (!(distance < least) && least != std::numeric_limits<double>::infinity()) continue;
            least = distance;
            best = {a, b};
        }
    return best;
}

Solid without_rings(Solid solid)
{
    EulerOperator op(solid);
    for (const FaceId f : solid.faces()) {
        const LoopId outer = solid.outer(f);
        while (solid.tables().loops[outer].next != outer) {
            const Corners corners = nearest(solid, outer, solid.tables().loops[outer].next);
            op.mekr(corners.outer, corners.ring);
        }
    }
    return solid;
}

} // namespace

Mesh mesh_of(const Solid& solid)
{
    const Solid plain = without_rings(solid);
    Mesh mesh;
    std::vector<std::uint32_t> index(plain.vertices().n_rows());
    for (const VertexId v : plain.vertices()) {
        index[v.index] = static_cast<std::uint32_t>(mesh.points.size());
        mesh.points.push_back(plain.point(v));
    }
    for (const FaceId f : plain.faces()) {
        std::vector<std::uint32_t>& polygon = mesh.polygons.emplace_back();
        for (const HalfEdgeId h : plain.chain(plain.outer(f))) polygon.push_back(index[plain.start(h).index]);
    }
    return mesh;
}

} // namespace topology
