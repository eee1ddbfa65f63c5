#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "apps/frame/document/change.h"
#include "apps/frame/document/selection.h"
#include "apps/frame/tools/working_plane.h"
#include "femoop/edit/bend.h"
#include "femoop/edit/place.h"

namespace frame {

/// A transformation of the selection by typed numbers.
struct Transform {
    enum class Kind : std::uint8_t { Move, Copy, Rotate, Mirror, Scale, Bend };

    Kind kind = Kind::Move;
    /// Move, Copy: the shift. Others: the centre, or a place of the mirror. z stays 0 in a plane.
    std::array<femoop::Quantity, 3> at{1.0, 0.0, 0.0};
    femoop::Quantity angle{90.0}; ///< [degrees] Rotate: counter-clockwise. Mirror in a plane: of its line, from +x
    bool is_in_space = false;
    /// In space Rotate: along the axis. Mirror: square to the plane.
    WorkingPlane::Normal normal = WorkingPlane::Normal::Z;
    double factor = 2.0;         ///< Scale; > 0
    int times = 1;               ///< Copy; 1 to 100
    bool keeps_original = false; ///< Mirror, Rotate: what is turned is a copy
    femoop::Bend bend{};         ///< Bend: of each member
    double least_rise = 0.0;     ///< Bend: a smaller one leaves a member straight
    std::vector<Part> parts{};   ///< that are transformed
    bool begins = true;          ///< its first number gets the keyboard where it is shown next

    femoop::Placement placement() const;
    bool copies() const { return kind == Kind::Copy || keeps_original; }
    std::size_t n_copies() const { return kind == Kind::Copy ? static_cast<std::size_t>(times) : 1; }
    /// What it does to the parts, as part of a gesture, so that its numbers can still change: what comes of it is
    /// joined to what it meets and has its names, and copies are selected.
    Change change(const femoop::Model& before) const;

private:
    Change bending() const;
};

/// As the kind begins: about the middle of the parts, a copy beside them.
Transform transform_of(Transform::Kind kind, const femoop::Model& model, const Selection& selection);

/// The parts that came last: those behind the first `n_nodes` nodes and `n_members` members.
Selection latest(const femoop::Model& model, std::size_t n_nodes, std::size_t n_members);

} // namespace frame
