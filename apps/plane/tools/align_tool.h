#pragma once

#include <optional>
#include <vector>

#include "apps/plane/backdrop/backdrop.h"

namespace plane {

/// Gives a backdrop its place, scale and turn by two of its places: both are picked in the picture, then it is told where
/// they belong. A length between them will do: the first one stays then, and the picture is not turned.
class AlignTool {
public:
    /// The next place is one of the picture; else it is one of the drawing.
    bool picks() const { return picked_.size() < 2; }
    bool has_begun() const { return !picked_.empty(); }
    const std::vector<FlatPoint>& picked() const { return picked_; }
    const std::optional<FlatPoint>& first_target() const { return first_target_; }

    /// The next place: picked, or where the first or the second picked one belongs. One that was picked, or told, for
    /// the first is not taken for the second. \returns what the last place ends
    std::optional<Alignment> add(const FlatPoint& place);
    /// Where the second one belongs; the first stays where nothing was told of it. \pre does not pick
    std::optional<Alignment> add_second(const FlatPoint& place);
    /// The first one comes where it belongs, and scale and turn are as before; nothing where it was not told.
    std::optional<Alignment> finish();
    /// Takes back the last place; false where there is none.
    bool escape();

    /// That typed lengths count from, and the place that they count towards. \pre does not pick
    FlatPoint from() const { return first_target_.value_or(picked_.front()); }
    FlatPoint towards() const { return from() + (picked_[1] - picked_[0]); }

private:
    std::vector<FlatPoint> picked_; ///< two at most
    std::optional<FlatPoint> first_target_;
};

} // namespace plane
