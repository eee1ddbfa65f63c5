#include "tests/bench/cgal_plane_reference.h"

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arr_walk_along_line_point_location.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <chrono>

namespace bench {

namespace {

using Clock = std::chrono::steady_clock;

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using MeshData = CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Inexact>,
                                                      CGAL::Delaunay_mesh_face_base_2<Inexact>>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Inexact, MeshData>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Constrained>;

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Lines = CGAL::Arr_segment_traits_2<Exact>;
using Arrangement = CGAL::Arrangement_2<Lines>;

constexpr double sine_squared_of_30_degrees = 0.25;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

std::vector<Lines::X_monotone_curve_2> lines_of(const std::vector<topology::Segment>& segments)
{
    std::vector<Lines::X_monotone_curve_2> lines;
    for (const auto& [a, b] : segments) lines.emplace_back(Exact::Point_2(a.x, a.y), Exact::Point_2(b.x, b.y));
    return lines;
}

std::size_t n_regions(const Arrangement& arrangement)
{
    return arrangement.number_of_faces() - arrangement.number_of_unbounded_faces();
}

} // namespace

CgalMesh cgal_mesh(const topology::MeshDomain& domain, double longest, const std::vector<topology::FlatPoint>& holes)
{
    const Clock::time_point begin = Clock::now();
    Constrained triangles;
    for (const std::vector<topology::CellNode>& loop : domain.loops) {
        std::vector<Constrained::Vertex_handle> around;
        for (const topology::CellNode node : loop)
            around.push_back(triangles.insert(Inexact::Point_2(domain.nodes[node].x, domain.nodes[node].y)));
        for (std::size_t i = 0; i < around.size(); ++i)
            triangles.insert_constraint(around[i], around[(i + 1) % around.size()]);
    }
    CGAL::Delaunay_mesher_2<Constrained, Criteria> mesher(triangles, Criteria(sine_squared_of_30_degrees, longest));
    std::vector<Inexact::Point_2> seeds;
    for (const topology::FlatPoint& hole : holes) seeds.emplace_back(hole.x, hole.y);
    mesher.set_seeds(seeds.begin(), seeds.end());
    mesher.refine_mesh();
    const double seconds = seconds_since(begin);
    std::size_t n = 0;
    for (auto face = triangles.finite_faces_begin(); face != triangles.finite_faces_end(); ++face)
        if (face->is_in_domain()) ++n;
    return {n, seconds};
}

CgalRegions cgal_sweep(const std::vector<topology::Segment>& segments)
{
    const std::vector<Lines::X_monotone_curve_2> lines = lines_of(segments);
    const Clock::time_point begin = Clock::now();
    Arrangement arrangement;
    CGAL::insert(arrangement, lines.begin(), lines.end());
    const double seconds = seconds_since(begin);
    return {n_regions(arrangement), seconds};
}

CgalRegions cgal_one_by_one(const std::vector<topology::Segment>& segments)
{
    const std::vector<Lines::X_monotone_curve_2> lines = lines_of(segments);
    const Clock::time_point begin = Clock::now();
    Arrangement arrangement;
    const CGAL::Arr_walk_along_line_point_location<Arrangement> walk(arrangement);
    std::size_t most = 0;
    for (const Lines::X_monotone_curve_2& line : lines) {
        CGAL::insert(arrangement, line, walk);
        most = std::max(most, n_regions(arrangement));
    }
    return {most, seconds_since(begin)};
}

} // namespace bench
