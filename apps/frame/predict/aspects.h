#pragma once

#include <cstdint>
#include <vector>

#include "apps/frame/predict/profile.h"

namespace frame {

/// What a teacher looks at in a sketched diagram, each by itself. Shares are 0 to 1; tolerances are those of a hand:
/// some hundredths of the member's length and of the largest ordinate.

/// The share of the length along which the guess is drawn and lies on the right side; near the axis either side is.
double sign_share(const Truth& truth, const Profile& guess);

/// Things that stand at places: how many the true diagram has, how many of them the guess has there, and how many it
/// has where there are none.
struct PlaceCount {
    int n_true = 0, n_found = 0, n_extra = 0;
    double share = 0.0; ///< what is a little beside its place, or too small, counts for a part

    bool is_about_something() const { return n_true + n_extra > 0; }
};
/// Where the diagram is zero: inside the member, and at its ends. A jump through zero is none.
PlaceCount zeros_found(const Truth& truth, const Profile& guess);
/// Jumps to the right side, at applied moments; what rises or falls over some length is none.
PlaceCount jumps_found(const Truth& truth, const Profile& guess);

/// 1 where the guess is largest at a place where the true diagram is nearly as large as anywhere, on the same side.
double extreme_share(const Truth& truth, const Profile& guess);

/// What is wrong with the guess between two load points.
enum class Flaw : std::uint8_t {
    None,
    NotDrawn,
    Straight, ///< where the true diagram is curved
    Curved,   ///< where it is straight
    Sloping,  ///< where it is constant
    Level,    ///< where it slopes
    OtherWay, ///< curved or sloping the other way
    Uneven,   ///< curved, but not like it
};
struct PieceMark {
    Truth::Piece piece;
    Flaw flaw = Flaw::None;
    double share = 0.0;
};
/// The degree of the diagram, piece by piece; pieces shorter than a twelfth of the member are not judged.
std::vector<PieceMark> pieces_marked(const Truth& truth, const Profile& guess);

} // namespace frame
