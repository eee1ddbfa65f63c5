#include "tests/femoop/methods/train/random_train.h"

#include <algorithm>

using namespace femoop;
using namespace femoop::influence;

namespace {

double fraction(Dice& dice) { return dice.roll(1, 996) / 997.0; }
double signed_fraction(Dice& dice) { return 2.0 * fraction(dice) - 1.0; }

double value(const LinePiece& piece, double s)
{
    double sum = 0.0;
    for (std::size_t k = piece.coefficients.size(); k-- > 0;) sum = sum * (s - piece.from) + piece.coefficients[k];
    return sum;
}

double integral(const LinePiece& piece, double s)
{
    double sum = 0.0;
    for (std::size_t k = piece.coefficients.size(); k-- > 0;)
        sum = sum * (s - piece.from) + piece.coefficients[k] / static_cast<double>(k + 1);
    return sum * (s - piece.from);
}

} // namespace

RandomTrain::RandomTrain(std::uint32_t seed)
{
    Dice dice(seed);
    const int n_pieces = static_cast<int>(dice.roll(1, 4)), n_axles = static_cast<int>(dice.roll(1, 4));
    for (int i = 0; i < n_pieces; ++i) {
        const double from = ends.back(), to = from + 2.0 + 3.0 * fraction(dice);
        line.pieces.push_back({from,
                               to,
                               {signed_fraction(dice), signed_fraction(dice), 0.3 * signed_fraction(dice),
                                0.05 * signed_fraction(dice)}});
        ends.push_back(to);
    }
    for (int i = 0; i < n_axles; ++i) train.axles.push_back(1.5 + signed_fraction(dice));
    for (int i = 1; i < n_axles; ++i) {
        const double least = 0.1 + 2.0 * fraction(dice);
        train.spacings.push_back({least, dice.sign() > 0.0 ? least : least + 3.0 * fraction(dice)});
    }
    train.both_directions = dice.sign() > 0.0;
    train.extent = static_cast<UniformExtent>(static_cast<int>(dice.roll(0, 3)));
    if (dice.sign() > 0.0) train.uniform = 0.3 + signed_fraction(dice);
    train.gap = fraction(dice);
    if (dice.sign() > 0.0) train.concentrated = {1.2 + signed_fraction(dice)};
}

double RandomTrain::ordinate(double s) const
{
    for (const LinePiece& piece : line.pieces)
        if (s >= piece.from && s <= piece.to) return value(piece, s);
    return 0.0;
}

double RandomTrain::area(double from, double to) const
{
    double sum = 0.0;
    for (const LinePiece& piece : line.pieces) {
        const double a = std::max(from, piece.from), b = std::min(to, piece.to);
        if (a < b) sum += integral(piece, b) - integral(piece, a);
    }
    return sum;
}

double RandomTrain::effect(const Placing& placing, ExtremeKind kind) const
{
    double sum = 0.0;
    if (placing.position) {
        double s = *placing.position;
        for (std::size_t i = 0; i < train.axles.size(); ++i) {
            if (i > 0) s += (placing.reversed ? 1.0 : -1.0) * placing.spacings[i - 1];
            sum += train.axles[i] * ordinate(s);
        }
    }
    for (const Stretch& stretch : placing.uniform) sum += train.uniform * area(stretch.from, stretch.to);
    for (std::size_t i = 0; i < placing.concentrated.size(); ++i) {
        if (!placing.concentrated[i]) continue;
        const double before = train.concentrated[i] * ordinate(*placing.concentrated[i] - 1e-12);
        const double after = train.concentrated[i] * ordinate(*placing.concentrated[i] + 1e-12);
        sum += kind == ExtremeKind::Max ? std::max(before, after) : std::min(before, after);
    }
    return sum;
}

Placing thrown(const RandomTrain& random, Dice& dice)
{
    Placing placing;
    double train_length = 0.0;
    for (const MovingTrain::Spacing& spacing : random.train.spacings) {
        placing.spacings.push_back(spacing.least + fraction(dice) * (spacing.most - spacing.least));
        train_length += placing.spacings.back();
    }
    placing.reversed = random.train.both_directions && dice.sign() > 0.0;
    const double run = fraction(dice) * (random.ends.back() + train_length);
    placing.position = placing.reversed ? random.ends.back() - run : run;
    return placing;
}
