#include "apps/euler/view/planar/planar_shapes.h"

#include "apps/euler/view/planar/embedding.h"
#include "apps/euler/view/planar/layout_on_its_way.h"
#include "apps/euler/view/shapes/name_places.h"
#include "apps/euler/view/solid/solid_shapes.h"
#include "topology/halfedge/check/shells.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace euler {

using topology::FaceId;
using topology::HalfEdgeId;
using topology::LoopId;
using topology::Solid;
using ui::translatable;

namespace {

constexpr double outside_radius = 1.25;
constexpr double pitch = 2.7;            // between the middles of shells, whose radius is 1
constexpr std::size_t most_edges = 6000; // that are drawn in the plane

struct Disc {
    ui::Point middle;
    double radius = 1.0;

    ui::Point at(ui::Point p) const { return middle + radius * p; }
};

/// n discs of one size side by side inside one.
std::vector<Disc> packed(const Disc& disc, std::size_t n)
{
    if (n == 1) return {disc};
    const double s = std::sin(std::numbers::pi / static_cast<double>(n)), share = s / (1.0 + s);
    std::vector<Disc> discs;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        discs.push_back(
            {disc.at((1.0 - share) * ui::Point{std::cos(angle), std::sin(angle)}), 0.9 * share * disc.radius});
    }
    return discs;
}

/// Draws one solid, shell by shell.
class PlanarLayout {
public:
    explicit PlanarLayout(const Solid& solid) : solid_(solid) { layout_.vertices.resize(solid.vertices().n_rows()); }

    void add_shell(FaceId outside, const Disc& disc)
    {
        layout_.outside[outside] = rim(disc);
        std::vector<LoopId> loops;
        for (const LoopId l : solid_.loops(outside)) loops.push_back(l);
        add_parts(loops, disc);
    }
    void leave_out(const topology::Shell& shell) { layout_.left_out.insert(shell.faces.begin(), shell.faces.end()); }
    PlacedSolid::Layout take() { return std::move(layout_); }

private:
    static topology::Point flat(ui::Point p) { return {p.x, p.y, 0.0}; }

    /// Far enough from the drawing for the outside's half-edges and its name.
    static std::vector<topology::Point> rim(const Disc& disc)
    {
        constexpr int n = 72;
        std::vector<topology::Point> circle;
        for (int i = 0; i < n; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / n;
            circle.push_back(flat(disc.at(outside_radius * ui::Point{std::cos(angle), std::sin(angle)})));
        }
        return circle;
    }

    void add_parts(const std::vector<LoopId>& around, const Disc& disc)
    {
        const std::vector<Disc> discs = packed(disc, around.size());
        for (std::size_t i = 0; i < around.size(); ++i) add_part(around[i], discs[i]);
    }

    void add_part(LoopId around, const Disc& disc)
    {
        const Embedding drawn = embedding(solid_, around);
        for (const auto& [v, at] : drawn.vertices) layout_.vertices[v.index] = flat(disc.at(at));
        for (const auto& [e, curve] : drawn.curves)
            for (const ui::Point p : curve) layout_.curves[e].push_back(flat(disc.at(p)));
        for (const LoopId l : drawn.loops)
            if (l != around) add_rings_inside(l, drawn, disc);
    }

    /// What else bounds the face of a loop, each part within it.
    void add_rings_inside(LoopId l, const Embedding& drawn, const Disc& disc)
    {
        std::vector<LoopId> others;
        for (const LoopId other : solid_.loops(solid_.face(l)))
            if (other != l) others.push_back(other);
        if (others.empty()) return;
        std::vector<ui::Point> outline;
        for (const HalfEdgeId h : solid_.chain(l)) add_path(outline, h, drawn, disc);
        constexpr double share = 0.75;
        const NamePlaces places = places_inside({outline});
        add_parts(others, {places.all.front(), share * places.room});
    }

    void add_path(std::vector<ui::Point>& outline, HalfEdgeId h, const Embedding& drawn, const Disc& disc) const
    {
        const auto curve = drawn.curves.find(*solid_.edge(h));
        if (curve == drawn.curves.end()) {
            outline.push_back(disc.at(drawn.vertices.at(solid_.start(h))));
            return;
        }
        std::vector<ui::Point> path = curve->second;
        if (solid_.plus(curve->first) != h) std::reverse(path.begin(), path.end());
        for (std::size_t i = 0; i + 1 < path.size(); ++i) outline.push_back(disc.at(path[i]));
    }

    const Solid& solid_;
    PlacedSolid::Layout layout_;
};

std::size_t n_half_edges(const Solid& solid, FaceId f)
{
    std::size_t n = 0;
    for (const LoopId l : solid.loops(f))
        for ([[maybe_unused]] const HalfEdgeId h : solid.chain(l)) ++n;
    return n;
}

FaceId outside_of(const Solid& solid, const topology::Shell& shell, std::optional<FaceId> wanted)
{
    if (wanted && std::find(shell.faces.begin(), shell.faces.end(), *wanted) != shell.faces.end()) return *wanted;
    return *std::max_element(shell.faces.begin(), shell.faces.end(),
                             [&](FaceId a, FaceId b) { return n_half_edges(solid, a) < n_half_edges(solid, b); });
}

std::optional<ui::Message> why_not_planar(const topology::Shell& shell)
{
    if (shell.genus > 0)
        return ui::Message(translatable("A shell has genus {genus}: it cannot be drawn in the plane without crossings. "
                                        "Its plane model shows it."),
                           {{"genus", std::to_string(shell.genus)}});
    if (shell.counts.edges > most_edges)
        return ui::Message(translatable("A shell has {count} edges: too many to be drawn in the plane."),
                           {{"count", std::to_string(shell.counts.edges)}});
    return std::nullopt;
}

/// All places of a layout that are seen.
void add_places(std::vector<ui::World3>& places, const PlacedSolid::Layout& layout)
{
    const auto add = [&](const topology::Point& p) { places.push_back({p.x, p.y, p.z}); };
    for (const auto& [f, rim] : layout.outside) std::for_each(rim.begin(), rim.end(), add);
}

} // namespace

/// All shells of all subjects, side by side.
PlanarMap::PlanarMap(std::span<const Subject> subjects, std::optional<Part> outside)
{
    double x = 0.0;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        const Solid& solid = *subjects[i].solid;
        PlanarLayout layout(solid);
        const bool is_here = outside && outside->subject == i && outside->entity.kind == topology::EntityKind::Face;
        const std::optional<FaceId> wanted = is_here ? std::optional(FaceId{outside->entity.index}) : std::nullopt;
        for (const topology::Shell& shell : topology::shells(solid)) {
            if (auto reason = why_not_planar(shell)) {
                layout.leave_out(shell);
                sentences_.push_back(std::move(*reason));
                continue;
            }
            layout.add_shell(outside_of(solid, shell, wanted), {{x, 0.0}, 1.0});
            x += pitch;
        }
        layouts_.push_back(layout.take());
    }
}

PlanarMap PlanarMap::on_its_way(std::span<const Subject> subjects, const PlanarMap& other,
                                std::span<const Subject> others, double share) const
{
    PlanarMap between = *this;
    for (std::size_t i = 0; i < std::min(subjects.size(), others.size()); ++i)
        between.layouts_[i] = layout_on_its_way({*subjects[i].solid, layouts_[i]},
                                                {*others[i].solid, other.layouts_[i]}, share);
    return between;
}

Shapes PlanarMap::shapes(std::span<const Subject> subjects, const ui::OrbitCamera& camera, const Look& look) const
{
    ui::OrbitCamera from_above = camera;
    from_above.look(ui::StandardView::Top);
    const ViewTransform transform(from_above);
    PlacedSolids placed;
    for (std::size_t i = 0; i < subjects.size(); ++i)
        placed.push_back(std::make_unique<PlacedSolid>(i, subjects[i], transform, layouts_[i]));
    Look flat = look;
    flat.explosion = 0.0;
    Shapes shapes = shapes_of(placed, transform, flat);
    for (const ui::Message& sentence : sentences_) shapes.sentences.push_back(look.tr(sentence));
    return shapes;
}

ui::OrbitCamera PlanarMap::fitted(ui::Size sheet) const
{
    constexpr double margin = 24.0; // [px]
    std::vector<ui::World3> places;
    for (const PlacedSolid::Layout& layout : layouts_) add_places(places, layout);
    ui::OrbitCamera camera;
    camera.look(ui::StandardView::Top);
    camera.fit(places, sheet, {margin, margin, margin, margin});
    return camera;
}

} // namespace euler
