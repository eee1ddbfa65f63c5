#include "apps/euler/view/marks.h"

#include <algorithm>

namespace euler {

Marks marks_of(const topology::Change& change, double progress)
{
    Marks marks;
    marks.created = change.created;
    marks.changed = change.changed;
    marks.killed = change.killed;
    marks.progress = std::clamp(progress, 0.0, 1.0);
    return marks;
}

bool is_drawn_before(const topology::Change& change)
{
    return std::any_of(change.killed.begin(), change.killed.end(), [](topology::Entity e) {
        return e.kind == topology::EntityKind::Edge || e.kind == topology::EntityKind::Vertex ||
               e.kind == topology::EntityKind::Face;
    });
}

MarkTable::MarkTable(const topology::Solid& solid, const Marks& marks)
    : progress_(std::clamp(marks.progress, 0.0, 1.0)), is_asked_(marks.legal.has_value())
{
    using topology::EntityKind;
    const auto rows = [&](EntityKind kind) -> std::vector<std::uint8_t>& {
        return flags_[static_cast<std::size_t>(kind)];
    };
    rows(EntityKind::Face).resize(solid.faces().n_rows());
    rows(EntityKind::Loop).resize(solid.loops().n_rows());
    rows(EntityKind::Edge).resize(solid.edges().n_rows());
    rows(EntityKind::HalfEdge).resize(solid.half_edges().n_rows());
    rows(EntityKind::Vertex).resize(solid.vertices().n_rows());
    set(marks.created, Created);
    set(marks.changed, Changed);
    set(marks.killed, Killed);
    set(marks.preview, Preview);
    set(marks.selected, Selected);
    if (marks.legal) set(*marks.legal, Legal);
    if (marks.hovered) set({*marks.hovered}, Hovered);
}

void MarkTable::set(const std::vector<topology::Entity>& entities, Flag flag)
{
    for (const topology::Entity e : entities) {
        auto& row = flags_[static_cast<std::size_t>(e.kind)];
        if (e.index >= row.size()) continue;
        row[e.index] = static_cast<std::uint8_t>(row[e.index] | flag);
        is_empty_ = false;
    }
}

double MarkTable::presence(topology::Entity e) const
{
    if (is_created(e)) return progress_;
    return is_killed(e) ? 1.0 - progress_ : 1.0;
}

} // namespace euler
