#pragma once

#include <array>
#include <optional>
#include <vector>

#include "apps/frame/predict/guess.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/methods/influence/load_path.h"
#include "femoop/result/curve.h"

namespace frame {

/// A diagram at the even places of a guess, its largest ordinate 1 or -1: what is left of it when its size is no
/// matter.
using Profile = std::array<std::optional<double>, Guess::n_places>;

/// Of what was sketched; gaps up to 4 % of the length are bridged by straight lines. Empty for a guess that is zero.
Profile profile(const Guess& guess);

/// The true diagram of a member: its profile, and what is known of it exactly. Places in lengths of the member.
struct Truth {
    struct Jump {
        double x = 0.0;
        double size = 0.0; ///< of the profile, from left to right
    };
    struct Piece {
        double from = 0.0, to = 0.0;
        int degree = 0;         ///< 0 constant, 1 straight, 2 parabola, 3 cubic ...
        bool is_series = false; ///< on an elastic foundation: no polynomial
    };
    Profile profile;
    double largest = 0.0;      ///< absolute value, in the units of the results
    std::vector<double> zeros; ///< places; the ends of a stretch of zero
    std::vector<Jump> jumps;   ///< that an eye can see
    std::vector<Piece> pieces; ///< between load points, as far as the formula changes there
};

/// From the exact solution, piece by piece.
Truth truth(const femoop::Curve& curve, femoop::MemberComponent component);
/// Of an influence line on a member of its path, from the member's first end on.
Truth truth(const femoop::influence::InfluenceLine& line, const femoop::influence::PathMember& on);

} // namespace frame
