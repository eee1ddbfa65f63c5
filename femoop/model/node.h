#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "femoop/model/component.h"
#include "femoop/model/dof.h"
#include "femoop/model/quantity/quantity.h"

namespace femoop {

/// How a support was written: by a keyword, or as the object form with `fixed`, `angle` and `springs`.
enum class SupportKind : std::uint8_t { Custom, Fixed, Pin, Roller };

/// A stiffness along one degree of freedom [force/length or moment/rad].
struct Spring {
    Dof dof = Dof::ux;
    Quantity stiffness; ///< > 0

    friend bool operator==(const Spring&, const Spring&) = default;
};

/// What holds a node. Blocked degrees of freedom, springs and settlements are in the support's own axes.
struct Support {
    SupportKind kind = SupportKind::Custom;
    DofSet fixed;                ///< of a Custom support; for a keyword see blocked()
    Quantity angle;              ///< [degrees], the support's axes turned counter-clockwise; 2D models only
    std::vector<Spring> springs; ///< at most one per degree of freedom, none on a blocked one

    /// The degrees of freedom blocked in a model of this kind: a keyword means what that model can hold.
    DofSet blocked(AnalysisKind kind) const;
    friend bool operator==(const Support&, const Support&) = default;
};

/// A joint of the structure.
struct Node {
    std::string id;
    std::array<Quantity, 3> at; ///< x, y and in 3D models z
    std::optional<Support> support;
    bool hinge = false;          ///< every member end at the node is released in rotation
    std::vector<Component> mass; ///< lumped mass per degree of freedom; modal analysis only

    friend bool operator==(const Node&, const Node&) = default;
};

} // namespace femoop
