#include "apps/drawing/results/range_words.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "apps/drawing/results/influence_picture.h"
#include "apps/drawing/results/moving_words.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/methods/influence/effect_name.h"

namespace drawing {

namespace {

using femoop::ExtremeKind;
using femoop::MovingEffect;
using femoop::influence::Placing;
using femoop::influence::SearchProof;
using femoop::influence::TrainResults;

/// One end of the range of an effect: its value, and what makes it.
struct EndOfRange {
    MovingEffect effect; ///< at its section
    const Placing* placing = nullptr;
    const femoop::Train* train = nullptr;
};

struct Range {
    EndOfRange max, min;
};

/// Numbers, effects and places of trains in the units of the sheet.
class PlaceWords {
public:
    PlaceWords(const femoop::Model& model, const DrawOptions& options)
        : model_(model), options_(options), units_(display_units(model, options))
    {}

    const ui::Catalogue& tr() const { return options_.tr; }
    std::string text(double value, ui::Measure measure) const { return with_minus(units_.text(value, measure)); }
    std::string name(const MovingEffect& effect) const { return with_minus(effect_text(model_, units_, effect)); }
    std::string component(const MovingEffect& effect) const
    {
        return femoop::influence::component_name(model_.analysis, effect);
    }

    std::string leading_axle(double position, bool is_reversed) const
    {
        return leading_axle_words(options_, units_, position, is_reversed);
    }

    std::string with_places(std::string sentence, const Placing& placing, const femoop::Train& train) const
    {
        return drawing::with_places(std::move(sentence), options_, units_, placing, !train.axles.empty(),
                                    train.uniform.has_value());
    }

private:
    const femoop::Model& model_;
    const DrawOptions& options_;
    ui::DisplayUnits units_;
};

/// Of all results of a structure, or of one effect.
class RangeWords {
public:
    RangeWords(const femoop::Model& model, const DrawOptions& options, const TrainResults& results)
        : words_(model, options)
    {
        for (const auto& extreme : results.extremes)
            add({end_of(model, extreme.effect, extreme.max, extreme.max_train),
                 end_of(model, extreme.effect, extreme.min, extreme.min_train)});
        for (const auto& effect : results.effects)
            add({{effect.effect, &effect.max, effect.max_train}, {effect.effect, &effect.min, effect.min_train}});
    }

    std::vector<std::string> lines() const
    {
        std::vector<std::string> lines;
        for (std::size_t i = 0; i < ranges_.size(); ++i) {
            const auto is_alike_here = [&](const Range& other) { return is_alike(ranges_[i], other); };
            if (std::any_of(ranges_.begin(), ranges_.begin() + static_cast<std::ptrdiff_t>(i), is_alike_here)) continue;
            std::vector<Range> together{ranges_[i]};
            std::copy_if(ranges_.begin() + static_cast<std::ptrdiff_t>(i) + 1, ranges_.end(),
                         std::back_inserter(together), is_alike_here);
            tell(together, lines);
        }
        return lines;
    }

private:
    void add(const Range& range)
    {
        ranges_.push_back(range);
        double& largest = size_of(range.max.effect);
        largest = std::max({largest, std::abs(range.max.placing->value), std::abs(range.min.placing->value)});
    }

    static EndOfRange end_of(const femoop::Model& model, const MovingEffect& effect,
                             const femoop::influence::WorstSection& worst, const femoop::Train* train)
    {
        const double length = femoop::geometry_of(model, model[*effect.member]).length;
        return {femoop::influence::at_section(effect, worst.inside, length), &worst.placing, train};
    }

    /// Ranges of one component of all members are told together, each reaction by itself.
    bool is_alike(const Range& a, const Range& b) const
    {
        return a.max.effect.member && b.max.effect.member &&
               words_.component(a.max.effect) == words_.component(b.max.effect);
    }

    void tell(const std::vector<Range>& together, std::vector<std::string>& lines) const
    {
        const auto most = std::ranges::max_element(together, {}, [&](const Range& one) { return value(one.max); });
        const auto least = std::ranges::min_element(together, {}, [&](const Range& one) { return value(one.min); });
        if (value(most->max) == 0.0 && value(least->min) == 0.0) {
            const MovingEffect& effect = most->max.effect;
            const std::string name = together.size() == 1 ? words_.name(effect) : words_.component(effect);
            lines.push_back(words_.tr()("{component} is zero wherever the loads stand", {{"component", name}}));
            return;
        }
        lines.push_back(sentence(most->max, words_.tr()("its largest value")));
        lines.push_back(sentence(least->min, words_.tr()("its least value")));
    }

    double& size_of(const MovingEffect& effect)
    {
        return femoop::influence::is_moment(effect) ? largest_moment_ : largest_force_;
    }

    /// Beside all others of its kind nothing but rounding is 0.
    double value(const EndOfRange& end) const
    {
        constexpr double rounding = 1e-9;
        const double size = femoop::influence::is_moment(end.effect) ? largest_moment_ : largest_force_;
        return std::abs(end.placing->value) > rounding * size ? end.placing->value : 0.0;
    }

    std::string sentence(const EndOfRange& end, const std::string& which) const
    {
        std::string said = words_.tr()("{effect} = {value} under {train}",
                                       {{"effect", words_.name(end.effect)},
                                        {"value", words_.text(value(end), measure_of(end.effect))},
                                        {"train", end.train->id}}) +
                           ", " + which;
        return words_.with_places(std::move(said), *end.placing, *end.train);
    }

    PlaceWords words_;
    std::vector<Range> ranges_;
    double largest_force_ = 0.0, largest_moment_ = 0.0;
};

/// One of the two searches of a proof.
class ProofWords {
public:
    ProofWords(const PlaceWords& words, const MovingEffect& effect, const SearchProof& proof, ExtremeKind kind)
        : words_(words), effect_(effect), proof_(proof), kind_(kind), entries_(proof.entries)
    {
        std::ranges::stable_sort(entries_, [&](const auto& a, const auto& b) {
            return kind_ == ExtremeKind::Max ? a.candidate.value > b.candidate.value
                                             : a.candidate.value < b.candidate.value;
        });
        constexpr double one_place = 1e-6; // of the range of positions
        for (const SearchProof::Entry& entry : entries_)
            near_ = std::max(near_, one_place * std::abs(entry.candidate.x - entries_.front().candidate.x));
    }

    std::vector<std::string> lines() const
    {
        const ui::Catalogue& tr = words_.tr();
        std::vector<std::string> lines;
        if (entries_.empty()) lines.push_back(tr("no position was looked at: what the axles do does not depend on it"));
        else {
            lines.push_back(looked_at());
            lines.push_back(tr(kind_ == ExtremeKind::Max ? ui::translatable("the largest: {candidate}")
                                                         : ui::translatable("the least: {candidate}"),
                               {{"candidate", best()}}));
            if (const auto equal = equals(); !equal.empty())
                lines.push_back(tr("equal to it: {candidate}", {{"candidate", first_of(equal)}}));
            if (const auto next = runner_up())
                lines.push_back(tr("next to it: {candidate}", {{"candidate", candidate(*next)}}));
        }
        if (proof_.uniform != 0.0)
            lines.push_back(tr("the uniform load adds {value}", {{"value", value(proof_.uniform)}}));
        if (proof_.concentrated != 0.0)
            lines.push_back(tr("the single forces add {value}", {{"value", value(proof_.concentrated)}}));
        return lines;
    }

private:
    using Kind = femoop::influence::PositionFunction::Candidate::Kind;

    std::string value(double number) const { return words_.text(number, measure_of(effect_)); }

    std::string looked_at() const
    {
        const auto n_roots = std::ranges::count_if(
            entries_, [](const SearchProof::Entry& entry) { return entry.candidate.kind == Kind::Root; });
        return words_.tr()(
            "{count} candidates were looked at: {breaks} sides of breaks, at which an axle passes the end "
            "of a piece of the line, and {roots} roots of the derivative between them",
            {{"count", std::to_string(entries_.size())},
             {"breaks", std::to_string(static_cast<std::ptrdiff_t>(entries_.size()) - n_roots)},
             {"roots", std::to_string(n_roots)}});
    }

    std::string candidate(const SearchProof::Entry& entry) const
    {
        return value(entry.candidate.value) + ", " + words_.leading_axle(entry.candidate.x, entry.reversed) + ", " +
               kind(entry.candidate.kind);
    }

    std::string kind(Kind kind) const
    {
        if (kind == Kind::Root) return words_.tr()("root of the derivative");
        return kind == Kind::BreakBefore ? words_.tr()("break, − side") : words_.tr()("break, + side");
    }

    std::string best() const
    {
        return proof_.best ? candidate(*proof_.best) : value(0.0) + ", " + words_.tr()("no axle on the path");
    }

    /// Other positions that are as good as the best one: forwards ascending, then reversed.
    std::vector<SearchProof::Entry> equals() const
    {
        std::vector<SearchProof::Entry> found, known;
        if (proof_.best) known.push_back(*proof_.best);
        for (const SearchProof::Entry& entry : proof_.entries) {
            const auto is_here = [&](const SearchProof::Entry& other) { return is_one_place(entry, other); };
            if (!proof_.is_best(entry) || std::ranges::any_of(known, is_here)) continue;
            known.push_back(entry);
            found.push_back(entry);
        }
        return found;
    }

    /// The sides of a break are one place, and so are breaks that rounding parts.
    bool is_one_place(const SearchProof::Entry& a, const SearchProof::Entry& b) const
    {
        return a.reversed == b.reversed && std::abs(a.candidate.x - b.candidate.x) <= near_;
    }

    std::string first_of(const std::vector<SearchProof::Entry>& equal) const
    {
        const std::string first = candidate(equal.front());
        if (equal.size() == 1) return first;
        return first + "; " + words_.tr()("and {count} more", {{"count", std::to_string(equal.size() - 1)}});
    }

    /// The first one that is worse than the best by more than rounding.
    std::optional<SearchProof::Entry> runner_up() const
    {
        const auto next = std::ranges::find_if(entries_,
                                               [&](const SearchProof::Entry& entry) { return !proof_.is_best(entry); });
        return next != entries_.end() ? std::optional(*next) : std::nullopt;
    }

    const PlaceWords& words_;
    const MovingEffect& effect_;
    const SearchProof& proof_;
    ExtremeKind kind_;
    std::vector<SearchProof::Entry> entries_; ///< the best first
    double near_ = 0.0;                       ///< positions that are one
};

} // namespace

std::string range_words(const femoop::Model& model, const DrawOptions& options, const TrainResults& results,
                        const std::string& title)
{
    return paragraph(title, RangeWords(model, options, results).lines());
}

std::string load_name(const femoop::Model& model, const DrawOptions& options, const femoop::MovingEnvelope& envelope)
{
    std::string trains;
    for (const femoop::TrainId id : envelope.trains)
        trains += (trains.empty() ? "" : ", ") + model.moving_loads.trains[id.index].id;
    if (envelope.factor != 1.0)
        trains = ui::number_text(envelope.factor, options.numbers) + " × " +
                 (envelope.trains.size() > 1 ? "(" + trains + ")" : trains);
    return envelope.with ? model.case_name(*envelope.with) + " + " + trains : trains;
}

std::string proof_words(const femoop::Model& model, const DrawOptions& options, const MovingEffect& effect,
                        const TrainResults::Proof& proof)
{
    const PlaceWords words(model, options);
    std::string text;
    for (const ExtremeKind kind : {ExtremeKind::Max, ExtremeKind::Min}) {
        const bool is_max = kind == ExtremeKind::Max;
        const std::string title = options.tr(is_max ? ui::translatable("How the largest {effect} was found")
                                                    : ui::translatable("How the least {effect} was found"),
                                             {{"effect", words.name(effect)}});
        text += paragraph(title, ProofWords(words, effect, is_max ? proof.max : proof.min, kind).lines());
    }
    return text;
}

} // namespace drawing
