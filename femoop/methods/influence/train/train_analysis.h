#pragma once

#include <optional>
#include <span>
#include <vector>

#include "femoop/methods/influence/influence_line.h"
#include "femoop/methods/influence/load_path.h"
#include "femoop/methods/influence/train/extreme_search.h"
#include "femoop/methods/influence/train/train_search.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop::influence {

/// What a train does to one effect.
struct TrainEffect {
    MovingEffect effect;
    Placing max, min;
    const Train *max_train = nullptr, *min_train = nullptr; ///< whose they are; of an envelope one of several
};

/// What it does to one component of a member, at the worst of its sections.
struct TrainExtreme {
    MovingEffect effect; ///< without a place
    WorstSection max, min;
    const Train *max_train = nullptr, *min_train = nullptr;
};

/// What trains do to one component along a member.
struct MemberEnvelope {
    TrainExtreme extreme;
    std::vector<TrainEffect> sections; ///< ascending; two where the case that stays jumps, the - side first
};

/// Section moments and torques, and the couples of supports.
bool is_moment(const MovingEffect& effect);

/// The loads of a train on an effect: impact on the axles alone, single forces of the size that the effect wants.
/// \throws ModelError  ResultsBeyondRange
MovingTrain moving_train(const Train& train, const MovingEffect& effect);

/// Every section force at `n` sections of each member, and every force of each support. \pre n >= 2
std::vector<MovingEffect> default_effects(const Model& model, std::size_t n);
/// Every section force of each member, without a place.
std::vector<MovingEffect> default_extremes(const Model& model);

/// `search_size` of the extreme of one component of one member.
double search_size(const Model& model, const Train& train);
/// Searches that are larger together are refused: some minutes.
inline constexpr double most_search_size = 1e8;

/// An effect without a place, at a section of its member of this length; at its end the - side.
MovingEffect at_section(MovingEffect effect, double x, double length);

/// Trains on one structure, which is analysed once. Holds on to the model, which must outlive it.
///
/// Accuracy  that of InfluenceAnalysis and of TrainSearch
class TrainAnalysis {
public:
    /// \throws ModelError, MechanismError  as `analyse`
    explicit TrainAnalysis(const Model& model, const AnalysisOptions& options = {});

    /// \throws MechanismError, ModelError  as InfluenceAnalysis::line
    std::vector<TrainEffect> effects(const Train& train, std::span<const MovingEffect> effects);
    TrainExtreme extreme(const Train& train, const MovingEffect& effect);

    /// The case that stays plus the factor times the worst of the trains.
    std::vector<TrainEffect> effects(const MovingEnvelope& envelope, std::span<const MovingEffect> effects);
    TrainExtreme extreme(const MovingEnvelope& envelope, const MovingEffect& effect);
    /// At `n` evenly spaced sections of a member, where the case that stays has its load points, and where the extremes
    /// are; its ends a hair inside. \param effect  without a place  \pre n >= 2
    MemberEnvelope along_member(const MovingEnvelope& envelope, const MovingEffect& effect, std::size_t n);
    /// What the case that stays does to an effect; 0 where there is none.
    double permanent(const MovingEnvelope& envelope, const MovingEffect& effect);

    /// The line of the effect along the train's path.
    InfluenceLine line(const Train& train, const MovingEffect& effect);
    /// The same, searched.
    TrainSearch search(const Train& train, const MovingEffect& effect);

    PathLayout path(const Train& train) const;
    const Model& unloaded() const { return lines_.model(); } ///< its load cases are the analysis' own
    const std::vector<Fault>& warnings() const { return lines_.warnings(); }

private:
    SectionLines section_lines(const Train& train, const MovingEffect& effect);
    const Results& permanent_results();
    std::vector<double> load_points(const MovingEnvelope& envelope, MemberId member);
    Permanent permanent_along(const MovingEnvelope& envelope, const MovingEffect& effect, ExtremeKind kind);

    const Model& model_;
    AnalysisOptions options_;
    InfluenceAnalysis lines_;
    std::optional<Results> permanent_;
};

} // namespace femoop::influence
