#pragma once

#include <optional>
#include <variant>

#include "apps/cross/session/beam_edit.h"
#include "apps/cross/session/session.h"

namespace cross {

/// What lies under the pointer in the picture of the structure, to be taken hold of.
struct NodeAim {
    femoop::NodeId node;
};
struct LoadAim {
    drawing::LoadMark mark;
};
struct SpanAim {
    femoop::MemberId member;
    double x = 0.0; ///< from its first end, a round place
    ui::Point at;   ///< on the sheet
};
struct EndAim { ///< the sign beyond a beam's end, where a span more begins
    Side side = Side::Right;
    ui::Point at; ///< on the sheet
};
using Aim = std::variant<std::monostate, NodeAim, LoadAim, SpanAim, EndAim>;

/// \param scale  of symbols: how large a hand's reach is
Aim aim_at(const femoop::Model& model, const Drawn& drawn, ui::Point at, double scale);

/// The place of a member, wherever it lies between its ends; round.
std::optional<SpanAim> member_at(const femoop::Model& model, const Drawn& drawn, ui::Point at);

/// Where the signs stand at which a span more begins; nothing at an end where several members meet.
std::optional<ui::Point> sign_beyond(const femoop::Model& model, const Drawn& drawn, Side side, double scale);

/// A hand in the picture of the structure. Whatever it does shows at once, and is one step of the history:
///
///     a support dragged along           moves it; off a beam: takes it away; an end onto its neighbour: a span less
///     a load's arrow pulled             changes its value; along the member: moves a point load
///     a member pressed between          puts a support there, which follows the hand
///     the sign beyond a beam's end      pulls a span out; a click makes it as long as the last
class DragController {
public:
    bool is_holding() const { return held_.has_value(); }
    /// \returns false where there is nothing to take hold of
    bool press(const Session& session, const Drawn& drawn, ui::Point at, double scale);
    void pull(Session& session, ui::Point at);
    /// \returns the node, where it was a click on one
    std::optional<femoop::NodeId> release(Session& session);

private:
    struct Held {
        femoop::Model model; ///< as it was
        Aim aim;
        Drawn drawn;
        ui::Point pressed;
        double scale = 1.0;
        bool has_moved = false;
    };

    void pull(Session& session, const NodeAim& aim, ui::Point at);
    void pull(Session& session, const LoadAim& aim, ui::Point at);
    void pull(Session& session, const SpanAim& aim, ui::Point at);
    void pull(Session& session, const EndAim& aim, ui::Point at);
    void pull(Session& /*session*/, std::monostate /*aim*/, ui::Point /*at*/) {}

    std::optional<Held> held_;
};

/// Changes what holds a node: pinned, fixed, free.
void change_support(Session& session, femoop::NodeId node);

} // namespace cross
