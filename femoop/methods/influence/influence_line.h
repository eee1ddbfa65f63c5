#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/discretisation/discretisation.h"
#include "femoop/methods/influence/load_path.h"
#include "femoop/methods/influence/member_motion.h"
#include "femoop/methods/influence/piecewise_line.h"
#include "femoop/methods/influence/sampled_line.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop::influence {

/// A stretch of a line between nodes, ends of the path and the section: one polynomial of degree three or less, but on
/// a foundation and along a taper, where it is that member's closed form and its pieces are power series.
struct LineStretch {
    MemberId member;
    double from = 0.0, to = 0.0;
    bool is_series = false; ///< on a foundation or along a taper: power series, each over a short piece
    std::size_t first_piece = 0, n_pieces = 1; ///< of the line
};

/// The effect of a unit load at s, as a function of s.
///
/// Signs   the effect's own: those of section forces, displacements and reactions (courseware/conventions.md)
/// Units   effect per force; of a couple, per moment
struct InfluenceLine {
    MovingEffect effect;
    PiecewiseLine ordinates;
    std::vector<LineStretch> stretches; ///< ascending
    std::vector<double> nodes;          ///< ends of the path's members: 0, ..., its length
};

/// A value at a place: at a jump there are two, the - side first.
struct LineStation {
    double s = 0.0, value = 0.0;
};

/// So many evenly spaced places of every member of the path, its ends included, and every jump. \pre n >= 2
std::vector<LineStation> stations(const InfluenceLine& line, std::size_t n);

/// What an effect is in a case. At a jump the side that it names, else the + side; at its member's end the - side.
double effect_in(const MovingEffect& effect, const CaseResult& result);
double effect_in(const MovingEffect& effect, const Curve& curve); ///< \pre of a member; the curve is its

/// Influence lines of one structure, which is analysed once: then a line costs a back substitution.
///
///     InfluenceAnalysis analysis(model);
///     const PathLayout path = lay_out(model, members);
///     const InfluenceLine M = analysis.line(path, unit_load(model.analysis, {}), effect);
///
/// Method    Mueller-Breslau: the line is the displacement of the path along the load, where the structure is loaded by
///           nothing but a unit dislocation (section force), a support moved by 1 against its reaction, or a unit force
///           (displacement). Where a constraint (inextensible, rigid) stands against such a motion, or nothing holds
///           against it, the line is put together from unit loads on the path, as many as make it exact; and where a
///           member is very short beside the structure and such loads contradict the line.
/// Accuracy  that of `analyse`; along the path closed forms, nothing is sampled
/// Source    [Kassimali, ch. 8-9]
/// Lesson    courseware/03-influence-lines.md
/// Reference courseware/reference/moving-loads.md
class InfluenceAnalysis {
public:
    /// \throws ModelError, MechanismError  as `analyse`
    explicit InfluenceAnalysis(const Model& model, const AnalysisOptions& options = {});

    /// \pre the path is one of the model's; the effect has its node and component, or member, component and place
    /// \throws MechanismError  the load drives a mechanism somewhere on the path
    ///         ModelError      the line cannot be trusted, or not be computed
    InfluenceLine line(const PathLayout& path, const NodeVector& load, const MovingEffect& effect);

    /// Many at once, each as alone.
    std::vector<InfluenceLine> lines(const PathLayout& path, const NodeVector& load,
                                     std::span<const MovingEffect> effects);

    /// How the structure moves by what the line is the displacement of: each of its members, along its own axes. Empty
    /// where no such motion gives the line, but unit loads on the path.
    /// \pre as `line`
    std::vector<MemberMotion> motion(const MovingEffect& effect);

    const Model& model() const { return model_; }                    ///< without its loads
    const std::vector<Fault>& warnings() const { return warnings_; } ///< of all lines so far, each once

private:
    /// What is made of one line: the load case that it is read from.
    struct Adjoint {
        const MovingEffect* effect;
        LoadCase load_case;
    };
    Results solve(std::vector<LoadCase> cases);
    void note(const std::vector<Fault>& warnings);
    ModelError refusal(const ModelError& error, const PathLayout& path, const MovingEffect& effect) const;
    std::vector<InfluenceLine> solved_lines(const PathLayout& path, const NodeVector& load,
                                            std::span<const MovingEffect> effects);
    void require_undriven(const PathLayout& path, const NodeVector& load);
    bool is_direct(const MovingEffect& effect) const;
    double unit_effect(const MovingEffect& effect, const NodeVector& load) const;
    double place(const MovingEffect& effect) const; ///< along the member
    Adjoint adjoint(const MovingEffect& effect) const;
    std::vector<InfluenceLine> adjoint_lines(const PathLayout& path, const NodeVector& load,
                                             const std::vector<Adjoint>& adjoints);
    InfluenceLine adjoint_line(const PathLayout& path, const NodeVector& load, Adjoint adjoint);
    InfluenceLine line_of(const PathLayout& path, const NodeVector& load, const MovingEffect& effect,
                          const CaseResult& moved) const;
    MemberMotion motion_in(const Curve& curve, MemberId member, const MovingEffect& effect) const;
    std::vector<SampledStretch> stretches_of(const PathMember& on, const MovingEffect& effect) const;
    InfluenceLine direct_line(const PathLayout& path, const NodeVector& load, const MovingEffect& effect);

    Model model_;
    LinearStatic analysis_;
    Discretisation structure_;
    bool loses_digits_;
    std::vector<Fault> warnings_;
    std::vector<MemberId> undriven_path_; ///< the last one that was looked at, with its load
    NodeVector undriven_load_{};
};

/// Lines that a model asks for, or that are asked of it, each along its own path.
struct InfluenceLines {
    std::vector<InfluenceLine> lines; ///< parallel to the definitions
    std::vector<Fault> warnings;
};

/// \pre `check_line` has no error of any  \throws as InfluenceAnalysis
InfluenceLines influence_lines(const Model& model, std::span<const InfluenceLineDefinition> definitions,
                               const AnalysisOptions& options = {});

} // namespace femoop::influence
