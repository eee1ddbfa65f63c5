#include "apps/drawing/results/line_motion.h"

#include <algorithm>
#include <cmath>

namespace drawing {

std::optional<double> drawn_motion(const InfluencePicture& picture)
{
    double largest = 0.0;
    for (const femoop::influence::MemberMotion& motion : picture.motion)
        for (const femoop::influence::MotionPiece& piece : motion)
            for (const double share : shares_of_piece) {
                const auto along = [&](femoop::LocalAxis axis) {
                    return piece.along[femoop::index(axis)](share * piece.length());
                };
                largest = std::max(largest, std::hypot(along(femoop::LocalAxis::x), along(femoop::LocalAxis::y),
                                                       along(femoop::LocalAxis::z)));
            }
    constexpr double most_of_line = 10.0; // what moves farther would leave the line flat
    return largest <= most_of_line * picture.line.ordinates.largest() ? std::optional(largest) : std::nullopt;
}

std::vector<std::string> motion_sentences(const femoop::Model& model, const InfluencePicture& picture,
                                          const ui::Catalogue& tr)
{
    std::vector<std::string> sentences{principle(model, picture.line.effect, tr)};
    if (picture.line.ordinates.largest() > 0.0 && !drawn_motion(picture))
        sentences.push_back(tr("This motion is not drawn: it is more than ten times as large as the line."));
    return sentences;
}

} // namespace drawing
