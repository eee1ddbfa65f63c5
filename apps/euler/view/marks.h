#pragma once

#include "topology/halfedge/operators/change.h"
#include "topology/halfedge/solid.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace euler {

/// What stands out in the picture of one solid. Entities that the solid has not are left out.
///
/// Created entities grow and killed ones shrink while `progress` runs from 0 to 1: a new edge out of its old vertex, a
/// new face out of nothing. So a step that kills is drawn on the solid as it was before, one that makes on the solid as
/// it is after: see `is_drawn_before`.
struct Marks {
    std::vector<topology::Entity> created, changed, killed;
    std::vector<topology::Entity> preview; ///< what an operator would make, in the solid as it would be
    std::vector<topology::Entity> selected;
    std::optional<std::vector<topology::Entity>>
        legal; ///< what may be picked; all else is grey. None: no pick is asked
    std::optional<topology::Entity> hovered;
    double progress = 1.0; ///< of the step, 0 to 1

    friend bool operator==(const Marks&, const Marks&) = default;
};

/// What an operator did, as marks.
Marks marks_of(const topology::Change& change, double progress);
/// True where the step takes an edge, a vertex or a face away, so that only the solid before it can show it going.
bool is_drawn_before(const topology::Change& change);

/// Marks by entity, found in constant time.
class MarkTable {
public:
    MarkTable(const topology::Solid& solid, const Marks& marks);

    bool is_created(topology::Entity e) const { return has(e, Created); }
    bool is_changed(topology::Entity e) const { return has(e, Changed); }
    bool is_killed(topology::Entity e) const { return has(e, Killed); }
    bool is_preview(topology::Entity e) const { return has(e, Preview); }
    bool is_selected(topology::Entity e) const { return has(e, Selected); }
    bool is_hovered(topology::Entity e) const { return has(e, Hovered); }
    bool is_legal(topology::Entity e) const { return has(e, Legal); }
    /// A pick is asked, and this is none that the operator takes.
    bool is_illegal(topology::Entity e) const { return is_asked_ && !has(e, Legal); }
    bool is_marked(topology::Entity e) const { return flags(e) != 0; }
    bool is_empty() const { return is_empty_; }

    /// How much of the entity is there, 0 to 1: less than 1 while it comes or goes.
    double presence(topology::Entity e) const;

private:
    enum Flag : std::uint8_t {
        Created = 1,
        Changed = 2,
        Killed = 4,
        Preview = 8,
        Selected = 16,
        Legal = 32,
        Hovered = 64,
    };
    void set(const std::vector<topology::Entity>& entities, Flag flag);
    std::uint8_t flags(topology::Entity e) const
    {
        const auto& row = flags_[static_cast<std::size_t>(e.kind)];
        return e.index < row.size() ? row[e.index] : std::uint8_t{0};
    }
    bool has(topology::Entity e, Flag flag) const { return (flags(e) & flag) != 0; }

    std::array<std::vector<std::uint8_t>, 5> flags_; ///< by kind and index
    double progress_;
    bool is_asked_;
    bool is_empty_ = true;
};

} // namespace euler
