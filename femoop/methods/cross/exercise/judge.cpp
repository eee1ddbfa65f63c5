#include "femoop/methods/cross/exercise/judge.h"

#include <algorithm>
#include <cmath>

namespace femoop::cross {

namespace {

constexpr double coarsest = 0.015;       // of a number
constexpr double coarsest_of_all = 3e-3; // of the largest of its kind
constexpr double no_difference = 1e-9;

/// Whether a number was meant by what was written.
struct JudgeMeasure {
    Entry entry;
    double scale = 0.0; ///< the largest number of its kind

    double error(const Figure& wanted) const { return std::abs(entry.value - wanted.value); }
    double tiny() const { return no_difference * std::max(scale, std::abs(entry.value)); }
    bool meets(const Figure& wanted) const
    {
        const double most = std::max(coarsest * std::abs(wanted.value), coarsest_of_all * scale);
        return error(wanted) <= std::min(entry.unit, most) + std::min(wanted.slack, 2.0 * most) + tiny();
    }
    /// Rounded to the digits that were written; a 0 is no rounding.
    bool meets_coarsely(const Figure& wanted) const
    {
        return entry.value != 0.0 && error(wanted) <= 0.5 * entry.unit + tiny();
    }
};

class Judge {
public:
    Judge(const Form& form, const std::vector<std::optional<Entry>>& entries)
        : form_(form), entries_(entries), formulas_(form, figures_)
    {
        entries_.resize(form.blanks.size());
    }

    void run()
    {
        for (std::size_t i = 0; i < form_.blanks.size(); ++i) {
            const std::vector<Figure> own = finite(formulas_.of(BlankId(i)), i);
            following.push_back(own.front().value);
            judgements.push_back(entries_[i] ? judged(i, own) : left_open(i));
            figures_.push_back(figure_of(i, own.front()));
        }
    }

    std::vector<Judgement> judgements;
    std::vector<double> following;

private:
    /// From numbers that lead nowhere, as from stiffnesses of 0, one goes on with what is right.
    std::vector<Figure> finite(std::vector<Figure> own, std::size_t i) const
    {
        for (Figure& figure : own)
            if (!std::isfinite(figure.value) || !std::isfinite(figure.slack))
                figure = {.value = form_.right[i], .is_clean = figure.is_clean};
        return own;
    }

    Judgement judged(std::size_t i, const std::vector<Figure>& own) const
    {
        const JudgeMeasure measure{*entries_[i], scale_of(form_.blanks[i])};
        const Figure right{.value = form_.right[i]};
        if (measure.meets(right)) return {Verdict::Right};
        for (const Figure& figure : own)
            if (measure.meets(figure)) return {figure.is_clean ? Verdict::Right : Verdict::FollowsRight};
        std::vector<Slip> slips = named(i, measure);
        if (slips.empty() && (measure.meets_coarsely(right) || measure.meets_coarsely(own.front())))
            slips.push_back(Slip::TooCoarse);
        if (slips.empty() && do_factors_miss_one(i)) slips.push_back(Slip::FactorsNotOne);
        return {slips.empty() ? Verdict::Wrong : Verdict::Slipped, slips};
    }

    /// Mistakes made with the numbers that were had, or with the right ones.
    std::vector<Slip> named(std::size_t i, const JudgeMeasure& measure) const
    {
        std::vector<SlipFigure> found = slips_of(form_, figures_, BlankId(i));
        const std::vector<Figure> right = right_figures(i);
        for (const SlipFigure& slip : slips_of(form_, right, BlankId(i))) found.push_back(slip);
        std::erase_if(found, [&](const SlipFigure& slip) {
            return !std::isfinite(slip.figure.value) || !measure.meets(slip.figure);
        });
        std::ranges::stable_sort(found, {}, [&](const SlipFigure& slip) {
            return std::round(measure.error(slip.figure) / std::max(measure.entry.unit, measure.tiny()));
        });
        std::vector<Slip> slips;
        for (const SlipFigure& slip : found)
            if (std::ranges::find(slips, slip.slip) == slips.end()) slips.push_back(slip.slip);
        return slips;
    }

    std::vector<Figure> right_figures(std::size_t n) const
    {
        std::vector<Figure> figures(n);
        for (std::size_t i = 0; i < n; ++i) figures[i].value = form_.right[i];
        return figures;
    }

    bool do_factors_miss_one(std::size_t i) const
    {
        const Blank& blank = form_.blanks[i];
        if (blank.asked != Asked::Factor) return false;
        double sum = 0.0, slack = 0.0;
        for (const EndId e : form_.problem[*form_.problem[blank.end].joint].ends) {
            const auto factor = form_.find(Asked::Factor, 0, 0, e.index);
            if (!factor) continue;
            if (!entries_[factor->index]) return false;
            sum += entries_[factor->index]->value;
            slack += entries_[factor->index]->unit;
        }
        return std::abs(sum - 1.0) > std::min(slack, coarsest) + no_difference;
    }

    Judgement left_open(std::size_t i) const
    {
        if (!is_forgotten(i)) return {};
        return {Verdict::Slipped, {Slip::CarryOverForgotten}};
    }

    /// The joint that it arrives at was balanced again, or its column was summed.
    bool is_forgotten(std::size_t i) const
    {
        const Blank& blank = form_.blanks[i];
        if (blank.asked != Asked::CarryOver || blank.may_stay_empty || form_.right[i] == 0.0) return false;
        const auto is_written = [&](const std::optional<BlankId>& id) { return id && entries_[id->index]; };
        for (std::size_t step = blank.step + 1; step < form_.turns[blank.sheet].size(); ++step)
            if (is_written(form_.find(Asked::Balance, blank.sheet, step, blank.end.index))) return true;
        return is_written(form_.find(Asked::Sum, blank.sheet, 0, blank.end.index));
    }

    Figure figure_of(std::size_t i, const Figure& own) const
    {
        const Verdict verdict = judgements[i].verdict;
        if (entries_[i]) return {entries_[i]->value, 0.5 * entries_[i]->unit, verdict == Verdict::Right};
        if (verdict == Verdict::Slipped) return {.value = 0.0, .is_clean = false};
        return own;
    }

    /// The largest number of the cell's kind in its sheet, of moments all of them.
    double scale_of(const Blank& blank) const
    {
        const auto kind = [](Asked asked) {
            const bool is_moment = asked == Asked::Balance || asked == Asked::CarryOver || asked == Asked::Sum;
            return is_moment ? Asked::FixedEnd : asked;
        };
        double scale = blank.asked == Asked::Holding      ? largest_part_of_holding(blank)
                       : blank.asked == Asked::Multiplier ? multiplier_that_matters()
                                                          : 0.0;
        for (std::size_t i = 0; i < form_.blanks.size(); ++i)
            if (kind(form_.blanks[i].asked) == kind(blank.asked) && form_.blanks[i].sheet == blank.sheet)
                scale = std::max(scale, std::abs(form_.right[i]));
        return scale;
    }

    /// A force may be the small difference of large ones.
    double largest_part_of_holding(const Blank& blank) const
    {
        double all = std::abs(form_.bare_holding[blank.sheet][blank.sway]);
        const std::vector<double>& per_moment = form_.holding_per_moment[blank.sheet][blank.sway];
        for (std::size_t e = 0; e < per_moment.size(); ++e) {
            const auto sum = form_.find(Asked::Sum, blank.sheet, 0, e);
            all = std::max(all, sum ? std::abs(per_moment[e] * form_.right[sum->index]) : 0.0);
        }
        return all;
    }

    /// One that gives the sway the moments of the loads.
    double multiplier_that_matters() const
    {
        const auto largest = [&](std::size_t sheet) {
            double moment = 0.0;
            for (const double value : form_.loading(sheet).fixed_end) moment = std::max(moment, std::abs(value));
            return moment;
        };
        return largest(1) > 0.0 ? largest(0) / largest(1) : 0.0;
    }

    const Form& form_;
    std::vector<std::optional<Entry>> entries_;
    std::vector<Figure> figures_;
    Formulas formulas_;
};

} // namespace

std::vector<Judgement> judge(const Form& form, const std::vector<std::optional<Entry>>& entries)
{
    Judge judge(form, entries);
    judge.run();
    return std::move(judge.judgements);
}

std::vector<double> following(const Form& form, const std::vector<std::optional<Entry>>& entries)
{
    Judge judge(form, entries);
    judge.run();
    return std::move(judge.following);
}

} // namespace femoop::cross
