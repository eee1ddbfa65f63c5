#include "apps/euler/view/solid/face_body.h"

#include "topology/halfedge/check/shells.h"
#include "ui/paint/mesh/keyhole.h"
#include "ui/paint/mesh/polygon_mesh.h"

#include <algorithm>
#include <cmath>

namespace euler {

using topology::FaceId;
using topology::Point;
using topology::Vector;

namespace {

using Rim = std::vector<Point>;

constexpr double flat_within = 1e-3;  // of the length of a face's outline: nobody sees the difference
constexpr double no_area = 1e-9;      // of the square of a face's outline
constexpr double outward = 0.7;       // of a face's distance from its shell's middle, where it is fully exploded
constexpr double along_normal = 0.12; // of the solid's extent

Vector twice_area(const Rim& rim)
{
    Vector sum;
    for (std::size_t i = 1; i + 1 < rim.size(); ++i) sum = sum + cross(rim[i] - rim[0], rim[i + 1] - rim[0]);
    return sum;
}

double perimeter(const Rim& rim)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < rim.size(); ++i) sum += length(rim[(i + 1) % rim.size()] - rim[i]);
    return sum;
}

/// Without the stretches that run forth and back along a strut.
Rim without_struts(const Rim& rim)
{
    Rim kept;
    for (const Point& p : rim) {
        const bool comes_back = kept.size() >= 2 && kept[kept.size() - 2] == p;
        if (comes_back) kept.pop_back();
        else kept.push_back(p);
    }
    auto first = kept.begin(), end = kept.end(); // a strut may have been begun anywhere on its way
    while (end - first >= 3 && (*(end - 2) == *first || *(end - 1) == *(first + 1))) {
        const bool turns_at_end = *(end - 2) == *first;
        if (turns_at_end) --end;
        first += turns_at_end ? 1 : 2;
    }
    return end - first >= 3 ? Rim(first, end) : Rim{};
}

Rim rim_of(const topology::Solid& solid, topology::LoopId loop, const HalfEdgePaths& paths)
{
    Rim rim;
    for (const topology::HalfEdgeId h : solid.chain(loop)) {
        if (!paths.is_curved(h)) {
            rim.push_back(paths.start(h));
            continue;
        }
        const auto path = paths(h);
        rim.insert(rim.end(), path.begin(), path.size() > 1 ? path.end() - 1 : path.end());
    }
    return rim;
}

bool is_flat(const std::vector<Rim>& rims, const Vector& normal, double within)
{
    const Point& origin = rims.front().front();
    for (const Rim& rim : rims)
        for (const Point& p : rim)
            if (std::abs(dot(normal, p - origin)) > within) return false;
    return true;
}

/// Two directions in the plane of a normal, with it right-handed.
struct Axes {
    Vector u, v;
    explicit Axes(const Vector& normal)
    {
        const Vector helper = std::abs(normal.z) < 0.9 ? Vector{0.0, 0.0, 1.0} : Vector{1.0, 0.0, 0.0};
        const Vector across = cross(helper, normal);
        u = (1.0 / length(across)) * across;
        v = cross(normal, u);
    }
    ui::Point operator()(const Vector& p) const { return {dot(u, p), dot(v, p)}; }
};

std::vector<std::vector<Rim>> triangles(const std::vector<Rim>& rims, const Vector& normal)
{
    const Axes axes(normal);
    std::vector<std::vector<ui::Point>> flat;
    for (const Rim& rim : rims) {
        flat.emplace_back();
        for (const Point& p : rim) flat.back().push_back(axes(p - rims.front().front()));
    }
    const std::vector<ui::LoopCorner> outline = ui::keyhole(flat);
    std::vector<ui::Point> in_plane;
    for (const auto& [loop, corner] : outline) in_plane.push_back(flat[loop][corner]);
    const auto at = [&](std::uint32_t i) { return rims[outline[i].loop][outline[i].corner]; };
    std::vector<std::vector<Rim>> result;
    for (const auto& [a, b, c] : ui::triangulation(in_plane)) result.push_back({{at(a), at(b), at(c)}});
    return result;
}

std::vector<std::vector<Rim>> pieces(const std::vector<Rim>& rims, const Vector& normal, double within)
{
    std::vector<Rim> kept;
    for (const Rim& rim : rims)
        if (Rim clean = without_struts(rim); !clean.empty()) kept.push_back(std::move(clean));
    if (kept.empty()) return {};
    if (is_flat(kept, normal, within)) return {kept};
    return triangles(kept, normal);
}

Point middle_of(const std::vector<Rim>& rims)
{
    Vector sum;
    double n = 0.0;
    for (const Point& p : rims.front()) {
        sum = sum + Vector{p.x, p.y, p.z};
        n += 1.0;
    }
    return Point{} + (1.0 / n) * sum;
}

FaceBody body_of(const topology::Solid& solid, FaceId f, const HalfEdgePaths& paths)
{
    std::vector<Rim> rims;
    Vector area;
    double around = 0.0;
    for (const topology::LoopId l : solid.loops(f)) {
        rims.push_back(rim_of(solid, l, paths));
        area = area + twice_area(rims.back());
        around += perimeter(rims.back());
    }
    FaceBody body{.face = f, .middle = middle_of(rims)};
    const double size = length(area);
    if (!(size > no_area * around * around)) return body;
    body.normal = (1.0 / size) * area;
    body.inner_radius = size / around;
    body.pieces = pieces(rims, body.normal, flat_within * around);
    return body;
}

} // namespace

FaceBodies::FaceBodies(const topology::Solid& solid, const HalfEdgePaths& paths) : places_(solid.faces().n_rows())
{
    bodies_.reserve(solid.faces().n_living());
    for (const FaceId f : solid.faces()) {
        places_[f.index] = bodies_.size();
        bodies_.push_back(body_of(solid, f, paths));
    }
}

void FaceBodies::lay_flat(const Rims& outside)
{
    for (FaceBody& body : bodies_) {
        body.normal = {0.0, 0.0, 1.0};
        const auto around = outside.find(body.face);
        if (around == outside.end()) continue;
        body.inner_radius = 0.0;
        if (body.pieces.empty()) body.pieces.emplace_back();
        body.pieces.front().insert(body.pieces.front().begin(), around->second);
    }
}

void FaceBodies::explode(const topology::Solid& solid, double how_far, double extent)
{
    if (how_far <= 0.0) return;
    for (const topology::Shell& shell : topology::shells(solid)) {
        Vector sum;
        for (const FaceId f : shell.faces) sum = sum + ((*this)[f].middle - Point{});
        const Point middle = Point{} + (1.0 / static_cast<double>(shell.faces.size())) * sum;
        for (const FaceId f : shell.faces) {
            FaceBody& body = bodies_[places_[f.index]];
            body.shift = how_far * (outward * (body.middle - middle) + along_normal * extent * body.normal);
        }
    }
}

} // namespace euler
