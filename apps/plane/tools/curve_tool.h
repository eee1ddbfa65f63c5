#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "apps/plane/document/curve_draft.h"

namespace plane {

/// What is drawn, and by which places:
///
///     Line       from place to place, each a curve of its own, until Esc or a second click at one place
///     Polyline   one curve, until Enter or a second click; a click on its first place closes it
///     Arc        start, a place on it, end              ArcCenter   centre, start, end; Shift the long way round
///     Circle     centre, a place on it                  Ellipse     centre, end of one axis, a place on the other side
///     Bezier     start, its two control points, end     Spline      as a polyline, 3 places or more
enum class CurveToolKind : std::uint8_t { Line, Polyline, Arc, ArcCenter, Circle, Ellipse, Bezier, Spline };

/// A curve that is being drawn, place by place.
class CurveTool {
public:
    explicit CurveTool(CurveToolKind kind) : kind_(kind) {}

    /// The next place. \returns the curve that it ends
    std::optional<CurveDraft> add(const DraftPlace& place, bool takes_long_way = false);
    /// Ends a curve of as many places as one likes; nothing where they are too few: then they stay.
    std::optional<CurveDraft> finish();
    /// Takes back the last place, of lines all that was begun; false where nothing was.
    bool escape();

    bool has_begun() const { return !places_.empty(); }
    bool lacks_places() const; ///< is begun, but cannot be ended yet
    const std::vector<DraftPlace>& places() const { return places_; }
    /// That typed places and lengths count from.
    std::optional<FlatPoint> from() const;
    /// The curve as it would be with a last place; until then what of it is seen.
    std::optional<CurveDraft> preview(const FlatPoint& pointer, bool takes_long_way = false) const;
    std::optional<CurveDraft> begun() const; ///< what is seen of it without one

private:
    std::optional<CurveDraft> seen(std::vector<DraftPlace> places, bool takes_long_way) const;
    std::optional<CurveDraft> whole(const std::vector<DraftPlace>& places, bool takes_long_way) const;
    std::size_t n_places() const; ///< that end it by themselves; 0: as many as one likes
    bool grows() const { return n_places() == 0; }
    std::size_t fewest() const { return kind_ == CurveToolKind::Spline ? 3 : 2; }

    CurveToolKind kind_;
    std::vector<DraftPlace> places_;
    std::optional<DraftPlace> first_; ///< of a chain of lines
};

} // namespace plane
