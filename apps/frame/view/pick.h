#pragma once

#include "apps/frame/view/view_options.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"
#include "ui/paint/painter.h"

#include <optional>
#include <variant>

namespace frame {

/// A section of a member.
struct MemberPlace {
    femoop::MemberId member;
    double x = 0.0; ///< from the first end of its flexible part, in the model's unit of length

    friend bool operator==(const MemberPlace&, const MemberPlace&) = default;
};

using Picked = std::variant<femoop::NodeId, MemberPlace>;

/// What lies under the cursor in a picture that `draw` made with the same arguments: the nearest node within a few
/// pixels, else the nearest member; over diagrams a member may be farther off, so that a value can be read at its
/// ordinate. In space the nearer one to the eye wins where two lie on one another.
std::optional<Picked> pick(const femoop::Model& model, const femoop::Results* results, const ViewOptions& options,
                           const ui::Painter& painter, ui::Point cursor);

/// Draws what is known of a section beside the cursor: the cut member with N, V and M as they act on it, and all
/// section forces and displacements with units. Marks the section in every panel.
/// Signs  as in femoop/result/curve.h; the arrows point the way in which the forces act on the face towards +x'
void draw_reading(ui::Painter& painter, const femoop::Model& model, const femoop::Results& results,
                  const ViewOptions& options, const MemberPlace& place, ui::Point cursor);

} // namespace frame
