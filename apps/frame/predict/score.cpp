#include "apps/frame/predict/score.h"

#include <algorithm>

namespace frame {

namespace {

double share_drawn(const Profile& guess)
{
    const auto n = std::ranges::count_if(guess, [](const auto& value) { return value.has_value(); });
    return static_cast<double>(n) / static_cast<double>(guess.size());
}

Profile turned_over(Profile profile)
{
    for (auto& value : profile)
        if (value) value = -*value;
    return profile;
}

double degree_share(const std::vector<PieceMark>& pieces)
{
    double sum = 0.0, length = 0.0;
    for (const PieceMark& mark : pieces) {
        sum += mark.share * (mark.piece.to - mark.piece.from);
        length += mark.piece.to - mark.piece.from;
    }
    return length > 0.0 ? sum / length : 0.0;
}

double weighed(const Score& score)
{
    double points = score.extreme, all = 1.0;
    const auto add = [&](double share) {
        points += 2.0 * share;
        all += 2.0;
    };
    if (score.zeros.is_about_something()) add(score.zeros.share);
    if (score.jumps.is_about_something()) add(score.jumps.share);
    if (!score.pieces.empty()) add(score.degree);
    return 0.5 * score.sign + 0.5 * points / all;
}

} // namespace

Score score(const Truth& truth, const Guess& guess)
{
    constexpr double nearly_none = 0.3, nearly_all = 0.8;
    Profile drawn = profile(guess);
    Score score{.drawn = share_drawn(drawn), .sign = sign_share(truth, drawn)};
    if (score.drawn == 0.0) return score;
    const Profile turned = turned_over(drawn);
    score.is_mirrored = score.sign < nearly_none && sign_share(truth, turned) > nearly_all;
    if (score.is_mirrored) drawn = turned;
    score.zeros = zeros_found(truth, drawn);
    score.jumps = jumps_found(truth, drawn);
    score.pieces = pieces_marked(truth, drawn);
    score.degree = degree_share(score.pieces);
    score.extreme = extreme_share(truth, drawn);
    score.share = weighed(score);
    return score;
}

} // namespace frame
