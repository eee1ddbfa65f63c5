// The speed of an exact envelope under a train beside a search that steps the train along: `ninja bench`.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "femoop/methods/influence/train/train_analysis.h"

namespace {

using namespace femoop;
using namespace femoop::influence;

constexpr int n_spans = 20;
constexpr std::size_t n_sections = 21;
constexpr int n_steps = 1000; // of the path's length, for the search by steps

double seconds_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Ten axles at distances that are not alike, in both directions.
Train train_on(std::vector<MemberId> path)
{
    Train train{.id = "ten axles", .path = std::move(path), .axles = {}, .spacings = {}};
    for (int i = 0; i < 10; ++i) train.axles.emplace_back(60.0 + 17.0 * (i % 4));
    for (int i = 0; i < 9; ++i) train.spacings.emplace_back(1.8 + 0.7 * (i % 3));
    train.both_directions = true;
    return train;
}

Model bridge()
{
    Model model;
    model.add(Material{.id = "concrete", .E = 3.4e7});
    model.add(Section{.id = "s", .A = 0.8, .Iz = 0.9});
    for (int i = 0; i <= n_spans; ++i) {
        Node node{.id = "N" + std::to_string(i),
                  .support = Support{.kind = i == 0 ? SupportKind::Pin : SupportKind::Roller}};
        node.at = {25.0 * i + 2.3 * (i % 3), 0.0, 0.0};
        model.add(std::move(node));
    }
    std::vector<MemberId> path;
    for (int i = 0; i < n_spans; ++i)
        path.push_back(
            model.add(Member{.id = "M" + std::to_string(i),
                             .nodes = {NodeId(static_cast<std::size_t>(i)), NodeId(static_cast<std::size_t>(i + 1))},
                             .material = MaterialId(0),
                             .section = SectionId(0)}));
    model.moving_loads.trains.push_back(train_on(std::move(path)));
    return model;
}

std::vector<MovingEffect> moments_and_shears(const Model& model)
{
    std::vector<MovingEffect> effects = default_effects(model, n_sections);
    std::erase_if(effects,
                  [](const MovingEffect& effect) { return !effect.member || effect.component == MemberComponent::N; });
    return effects;
}

/// The largest at so many positions in each direction.
double largest_by_steps(const PiecewiseLine& line, const MovingTrain& train, double length)
{
    double largest = 0.0, train_length = 0.0;
    for (const MovingTrain::Spacing& spacing : train.spacings) train_length += spacing.least;
    for (const double direction : {1.0, -1.0})
        for (int i = 0; i <= n_steps; ++i) {
            const double run = (length + train_length) * i / n_steps;
            double s = direction > 0.0 ? run : length - run, effect = 0.0;
            for (std::size_t k = 0; k < train.axles.size(); ++k) {
                if (s >= 0.0 && s <= length) effect += train.axles[k] * line.value(s);
                if (k < train.spacings.size()) s -= direction * train.spacings[k].least;
            }
            largest = std::max(largest, effect);
        }
    return largest;
}

void bench_envelope()
{
    const Model model = bridge();
    const Train& train = model.moving_loads.trains.front();
    const std::vector<MovingEffect> effects = moments_and_shears(model);
    auto start = std::chrono::steady_clock::now();
    TrainAnalysis analysis(model);
    const std::vector<TrainEffect> exact = analysis.effects(train, effects);
    const double exact_time = seconds_since(start);

    InfluenceAnalysis lines(model);
    const PathLayout path = lay_out(model, members_of(model, train.path));
    start = std::chrono::steady_clock::now();
    const auto all = lines.lines(path, unit_load(model.analysis, {}), effects);
    const double line_time = seconds_since(start);
    start = std::chrono::steady_clock::now();
    double worst_error = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double stepped = largest_by_steps(all[i].ordinates, moving_train(train, effects[i]), path.length());
        const double value = exact[i].max.value;
        if (value > 1e-3) worst_error = std::max(worst_error, (value - stepped) / value);
    }
    std::printf(
        "envelope of M and V, %d spans, %zu sections each, 10 axles, both directions: exact %.3f s (lines %.3f); "
        "largest alone by steps of L/%d %.3f s, %.1e too small\n",
        n_spans, n_sections, exact_time, line_time, n_steps, seconds_since(start), worst_error);
}

} // namespace

int main()
{
    bench_envelope();
    return 0;
}
