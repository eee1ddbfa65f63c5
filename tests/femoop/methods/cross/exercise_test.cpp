#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "femoop/methods/cross/exercise/hint.h"
#include "femoop/methods/cross/exercise/judge.h"
#include "femoop/methods/cross/exercise/seeded.h"
#include "femoop/methods/cross/slope_deflection.h"
#include "femoop/model/check/check.h"
#include "tests/femoop/methods/cross/frames.h"
#include "tests/femoop/methods/cross/random_frame.h"
#include "tests/samples.h"

using namespace femoop;
using namespace femoop::cross;
using doctest::Approx;

namespace {

using Entries = std::vector<std::optional<Entry>>;

constexpr std::array difficulties{Difficulty::FixedEnds,    Difficulty::PinnedEnd, Difficulty::Overhang,
                                  Difficulty::SeveralSpans, Difficulty::Frame,     Difficulty::SwayFrame};
constexpr std::uint32_t n_seeds = 500;

Form form_of_seed(Difficulty difficulty, std::uint32_t seed)
{
    return form_of(seeded_model(difficulty, seed), CaseId(0)).value();
}

/// One who writes every number with so many decimals and goes on with what is written.
Entry written(double value, int decimals)
{
    const double unit = std::pow(10.0, -decimals);
    return {std::round(value / unit) * unit, unit};
}

Entries worked(const Form& form, const Entries& begun, int decimals)
{
    Entries entries = begun;
    entries.resize(form.blanks.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (entries[i]) continue;
        const int more = form.blanks[i].asked == Asked::Factor || form.blanks[i].asked == Asked::Stiffness ||
                                 form.blanks[i].asked == Asked::Multiplier
                             ? 2
                             : 0;
        entries[i] = written(following(form, entries)[i], decimals + more);
    }
    return entries;
}

Entries exactly_worked(const Form& form, Entries entries = {})
{
    entries.resize(form.blanks.size());
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (!entries[i]) entries[i] = Entry{following(form, entries)[i], 0.0};
    return entries;
}

bool is_good(const Judgement& judgement)
{
    return judgement.verdict == Verdict::Right || judgement.verdict == Verdict::FollowsRight;
}

std::vector<Figure> right_figures(const Form& form, std::size_t n)
{
    std::vector<Figure> figures;
    for (std::size_t i = 0; i < n; ++i) figures.push_back({.value = form.right[i]});
    return figures;
}

/// Two spans, 6 m with 12 kN/m and 4 m with 40 kN in the middle; the left end fixed, the right one pinned.
Model two_spans()
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("B", 6, 0, roller).node("C", 10, 0, roller);
    made.member("A", "B").member("B", "C").uniform("AB", -12).point("BC", 2, -40);
    return made.model;
}

/// The judgement of one number where nothing else was written.
struct Paper {
    explicit Paper(const Model& model) : form(form_of(model, CaseId(0)).value()), entries(form.blanks.size()) {}
    BlankId cell(Asked asked, std::string_view end, std::size_t step = 0, std::size_t sheet = 0) const
    {
        return form.find(asked, sheet, step, form.problem.find_end(end).value().index).value();
    }
    Judgement written(BlankId id, double value, double unit = 0.0)
    {
        entries[id.index] = Entry{value, unit};
        return judge(form, entries)[id.index];
    }
    Form form;
    Entries entries;
};

bool names(const Judgement& judgement, Slip slip)
{
    return judgement.verdict == Verdict::Slipped && std::ranges::find(judgement.slips, slip) != judgement.slips.end();
}

} // namespace

TEST_CASE("The right sheet of every exercise is judged right throughout")
{
    for (const Difficulty difficulty : difficulties)
        for (std::uint32_t seed = 0; seed < n_seeds; ++seed) {
            CAPTURE(static_cast<int>(difficulty));
            CAPTURE(seed);
            const Form form = form_of_seed(difficulty, seed);
            Entries entries(form.blanks.size());
            for (std::size_t i = 0; i < entries.size(); ++i) entries[i] = Entry{form.right[i], 0.0};
            for (const Judgement& judgement : judge(form, entries)) CHECK(judgement.verdict == Verdict::Right);
        }
}

TEST_CASE("A pupil who rounds every number and goes on with it is right throughout")
{
    for (const Difficulty difficulty : difficulties)
        for (std::uint32_t seed = 0; seed < 40; ++seed)
            for (const int decimals : {1, 2, 3}) {
                CAPTURE(static_cast<int>(difficulty));
                CAPTURE(seed);
                CAPTURE(decimals);
                const Form form = form_of_seed(difficulty, seed);
                const std::vector<Judgement> all = judge(form, worked(form, {}, decimals));
                for (std::size_t i = 0; i < all.size(); ++i) {
                    CAPTURE(i);
                    CHECK(all[i].verdict == Verdict::Right);
                }
            }
}

TEST_CASE("Every mistake is called by its name and what follows from it is right")
{
    std::set<Slip> met;
    for (const Difficulty difficulty : difficulties)
        for (std::uint32_t seed = 0; seed < samples(12, 4); ++seed) {
            const Form form = form_of_seed(difficulty, seed);
            for (std::size_t i = 0; i < form.blanks.size(); ++i)
                for (const SlipFigure& slip : slips_of(form, right_figures(form, i), BlankId(i))) {
                    const double value = slip.figure.value;
                    if (!std::isfinite(value) || std::abs(value - form.right[i]) < 1e-6) continue;
                    CAPTURE(static_cast<int>(difficulty));
                    CAPTURE(seed);
                    CAPTURE(i);
                    CAPTURE(static_cast<int>(slip.slip));
                    Entries begun(form.blanks.size());
                    begun[i] = Entry{value, 0.0};
                    const std::vector<Judgement> all = judge(form, exactly_worked(form, begun));
                    CHECK(names(all[i], slip.slip));
                    met.insert(slip.slip);
                    bool all_good = true;
                    for (std::size_t j = 0; j < all.size(); ++j) all_good = all_good && (j == i || is_good(all[j]));
                    CHECK(all_good);
                }
        }
    CHECK(met.size() >= 34);
}

TEST_CASE("Mistakes with rounded numbers are still called by their names")
{
    std::size_t n = 0, n_named = 0;
    for (const Difficulty difficulty : difficulties)
        for (std::uint32_t seed = 0; seed < 10; ++seed) {
            const Form form = form_of_seed(difficulty, seed);
            for (std::size_t i = 0; i < form.blanks.size(); ++i)
                for (const SlipFigure& slip : slips_of(form, right_figures(form, i), BlankId(i))) {
                    Entries entries(form.blanks.size());
                    for (std::size_t j = 0; j < i; ++j) entries[j] = Entry{form.right[j], 0.0};
                    if (!std::isfinite(slip.figure.value)) continue;
                    entries[i] = written(slip.figure.value, 3);
                    const Judgement judgement = judge(form, entries)[i];
                    if (judgement.verdict == Verdict::Right) continue; // it gives nearly the same number
                    ++n;
                    n_named += names(judgement, slip.slip) ? 1 : 0;
                }
        }
    CHECK(n > 2000);
    CHECK(n_named == n);
}

TEST_CASE("qL2/8 for qL2/12 and PL/8 for 3PL/16 are called by their names")
{
    Paper sheet(two_spans());
    const double qL2 = 12.0 * 36.0, PL = 40.0 * 4.0;
    const BlankId AB = sheet.cell(Asked::FixedEnd, "AB"), BC = sheet.cell(Asked::FixedEnd, "BC");
    CHECK(sheet.written(AB, qL2 / 12.0).verdict == Verdict::Right);
    CHECK(names(sheet.written(AB, -qL2 / 12.0), Slip::OppositeSign));
    CHECK(names(sheet.written(AB, qL2 / 8.0), Slip::FixedAsPinned));
    CHECK(sheet.written(BC, 3.0 * PL / 16.0).verdict == Verdict::Right);
    CHECK(names(sheet.written(BC, PL / 8.0), Slip::PinnedAsFixed));
    CHECK(sheet.written(BC, 17.3).verdict == Verdict::Wrong);
    CHECK_FALSE(names(sheet.written(AB, -qL2 / 12.0), Slip::PinnedAsFixed)); // no end of AB is pinned
    CHECK_FALSE(names(sheet.written(BC, -3.0 * PL / 16.0), Slip::PinnedAsFixed));
    CHECK(names(sheet.written(BC, -PL / 8.0), Slip::PinnedAsFixed));
    CHECK(names(sheet.written(sheet.cell(Asked::FixedEnd, "CB"), -PL / 8.0), Slip::PinnedEndHolds));
}

TEST_CASE("Stiffness and factors know the pin and the length")
{
    Paper sheet(two_spans()); // k = 4/6 and 3/4
    const BlankId BA = sheet.cell(Asked::Stiffness, "BA"), BC = sheet.cell(Asked::Stiffness, "BC");
    CHECK(sheet.written(BC, 3.0 / 4.0).verdict == Verdict::Right);
    CHECK(names(sheet.written(BC, 4.0 / 4.0), Slip::PinnedAsFixed));
    CHECK(names(sheet.written(BA, 3.0 / 6.0), Slip::FixedAsPinned));
    CHECK(names(sheet.written(BA, 4.0), Slip::NoLength));
    CHECK(names(sheet.written(BA, 1.0 / 6.0), Slip::BareStiffness));
    CHECK(sheet.written(BA, 0.667, 0.001).verdict == Verdict::Right);
    sheet.written(BC, 3.0 / 4.0);
    const BlankId mu = sheet.cell(Asked::Factor, "BA"), other = sheet.cell(Asked::Factor, "BC");
    CHECK(sheet.written(mu, 8.0 / 17.0).verdict == Verdict::Right);
    CHECK(names(sheet.written(mu, 9.0 / 17.0), Slip::ExchangedFactor));
    CHECK(names(sheet.written(mu, 0.5), Slip::EqualShares));
    CHECK(names(sheet.written(mu, 0.4), Slip::UnmodifiedFactor)); // (2/3) / (2/3 + 1)
    CHECK(names(sheet.written(mu, 47.06, 0.01), Slip::Percent));
    sheet.written(other, 0.8);
    CHECK(names(sheet.written(mu, 0.43), Slip::FactorsNotOne));
}

TEST_CASE("Too few digits are told from a mistake")
{
    Paper sheet(two_spans());
    const BlankId mu = sheet.cell(Asked::Factor, "BC"); // 9/17 = 0.529
    CHECK(sheet.written(mu, 0.53, 0.01).verdict == Verdict::Right);
    CHECK(sheet.written(mu, 0.52, 0.01).verdict != Verdict::Right);
    CHECK(sheet.written(mu, 0.5294, 0.0001).verdict == Verdict::Right);
    CHECK(sheet.written(mu, 0.5290, 0.0001).verdict != Verdict::Right);
    CHECK(names(sheet.written(mu, 1.0, 1.0), Slip::TooCoarse));
    CHECK_FALSE(names(sheet.written(sheet.cell(Asked::Factor, "BA"), 0.0, 1.0), Slip::TooCoarse)); // 8/17
}

TEST_CASE("A balance is turned about and shared and carried over by half")
{
    Paper sheet(two_spans());
    const double unbalance = -36.0 + 30.0;
    const BlankId BA = sheet.cell(Asked::Balance, "BA"), AB = sheet.cell(Asked::CarryOver, "AB");
    CHECK(sheet.written(BA, -unbalance * 8.0 / 17.0).verdict == Verdict::Right);
    CHECK(names(sheet.written(BA, unbalance * 8.0 / 17.0), Slip::BalanceNotReversed));
    CHECK(names(sheet.written(BA, -unbalance * 9.0 / 17.0), Slip::OtherFactor));
    CHECK(names(sheet.written(BA, -unbalance), Slip::NotShared));
    CHECK(names(sheet.written(BA, 36.0 * 8.0 / 17.0), Slip::MomentNotCounted));
    sheet.written(BA, 3.0);
    CHECK(sheet.written(AB, 1.5).verdict == Verdict::FollowsRight);
    CHECK(sheet.written(AB, -0.5 * unbalance * 8.0 / 17.0).verdict == Verdict::Right);
    CHECK(names(sheet.written(AB, 3.0), Slip::CarriedWhole));
    CHECK(names(sheet.written(AB, -1.5), Slip::CarriedWithOtherSign));
    CHECK(names(sheet.written(AB, 0.0), Slip::CarryOverForgotten));
    const BlankId CB = sheet.cell(Asked::CarryOver, "CB");
    CHECK(sheet.form[CB].may_stay_empty);
    CHECK(sheet.written(CB, 0.0).verdict == Verdict::Right);
    CHECK(names(sheet.written(CB, -0.25 * unbalance * 9.0 / 17.0 * 2.0), Slip::CarriedToPinnedEnd));
}

TEST_CASE("A cell that a carry-over left empty is a mistake once its column is summed")
{
    Paper sheet(two_spans());
    const BlankId AB = sheet.cell(Asked::CarryOver, "AB"), sum = sheet.cell(Asked::Sum, "AB");
    CHECK(judge(sheet.form, sheet.entries)[AB.index].verdict == Verdict::Open);
    CHECK(sheet.written(sum, 36.0).verdict == Verdict::FollowsRight);
    CHECK(names(judge(sheet.form, sheet.entries)[AB.index], Slip::CarryOverForgotten));
    const double carried = 0.5 * 6.0 * 8.0 / 17.0;
    CHECK(sheet.written(sum, 36.0 + carried).verdict == Verdict::Right);
    sheet.written(AB, carried);
    CHECK(names(sheet.written(sum, 36.0), Slip::LineForgotten));
}

TEST_CASE("What was had counts where a stiffness of nothing leads nowhere")
{
    Paper sheet(two_spans());
    sheet.written(sheet.cell(Asked::Stiffness, "BA"), 0.0);
    sheet.written(sheet.cell(Asked::Stiffness, "BC"), 0.0);
    const BlankId mu = sheet.cell(Asked::Factor, "BA");
    CHECK(sheet.written(mu, 8.0 / 17.0).verdict == Verdict::Right);
    for (const double huge : {1e300, -1e300, 1e-300, std::numeric_limits<double>::max()})
        for (const Judgement& judgement : judge(sheet.form, Entries(sheet.form.blanks.size(), Entry{huge, 0.0})))
            CHECK(judgement.verdict != Verdict::Open);
    for (const double value : following(sheet.form, sheet.entries)) CHECK(std::isfinite(value));
}

TEST_CASE("A sway's sheet is added as often as frees its prop")
{
    for (std::uint32_t seed = 0; seed < n_seeds; ++seed) {
        CAPTURE(seed);
        const Model model = seeded_model(Difficulty::SwayFrame, seed);
        const Form form = form_of(model, CaseId(0)).value();
        const std::vector<double> exact = slope_deflection(model, form.problem).moments;
        double largest = 0.0;
        for (const double moment : exact) largest = std::max(largest, std::abs(moment));
        for (std::size_t e = 0; e < exact.size(); ++e)
            if (const auto cell = form.find(Asked::Final, 0, 0, e))
                CHECK(std::abs(form.right[cell->index] - exact[e]) < 0.08 * largest); // a hand stops at 2 %
    }
}

TEST_CASE("Any seed gives a sound structure with short moments and work to do and gives it again")
{
    for (const Difficulty difficulty : difficulties) {
        std::set<std::string> different;
        for (std::uint32_t seed = 0; seed < 1000; ++seed) {
            CAPTURE(static_cast<int>(difficulty));
            CAPTURE(seed);
            const Model model = seeded_model(difficulty, seed * 4294967U);
            if (seed % 50 == 0) CHECK(model == seeded_model(difficulty, seed * 4294967U));
            CHECK(check(model).empty());
            const Problem problem = problem_of(model, CaseId(0));
            const bool sways = difficulty == Difficulty::SwayFrame;
            CHECK(problem.sways.size() == (sways ? 1U : 0U));
            double largest = 0.0;
            for (const double moment : problem.loading.fixed_end) {
                largest = std::max(largest, std::abs(moment));
                CHECK(std::abs(1000.0 * moment - std::round(1000.0 * moment)) < 1e-6);
            }
            CHECK(largest >= 15.0);
            CHECK(largest <= 400.0);
            CHECK(largest_unbalance(locked_state(problem, problem.loading)) >= 0.08 * largest);
            different.insert(std::to_string(largest) + " " + std::to_string(problem.members[0].length));
        }
        CHECK(different.size() > 20);
    }
    CHECK(form_of(seeded_model(Difficulty::SeveralSpans, 0xFFFFFFFFU), CaseId(0)).has_value());
}

TEST_CASE("Every cell has a hint and none has more than three")
{
    for (const Difficulty difficulty : difficulties)
        for (std::uint32_t seed = 0; seed < 20; ++seed) {
            const Form form = form_of_seed(difficulty, seed);
            for (std::size_t i = 0; i < form.blanks.size(); ++i) {
                const std::size_t n = hints_for(form, BlankId(i)).size();
                CHECK(n >= 1);
                CHECK(n <= 3);
            }
        }
}

TEST_CASE("Structures of every kind can be an exercise and too long ones are none")
{
    std::size_t n = 0;
    for (unsigned seed = 0; seed < 60; ++seed)
        for (const FarEnds far_ends : {FarEnds::Modified, FarEnds::ReleasedOnSheet, FarEnds::Plain})
            for (const Model& model : {random_beam(seed), random_frame(seed)})
                for (const Order order : {Order::Largest, Order::AllAtOnce}) {
                    CAPTURE(seed);
                    CAPTURE(static_cast<int>(far_ends));
                    std::optional<Form> form;
                    try {
                        form = form_of(model, CaseId(0), far_ends, {.procedure = {.order = order}});
                    } catch (const ModelError&) {
                        continue; // the method does not take it
                    }
                    if (!form) continue;
                    ++n;
                    Entries entries(form->blanks.size());
                    for (std::size_t i = 0; i < entries.size(); ++i) entries[i] = Entry{form->right[i], 0.0};
                    for (const Judgement& judgement : judge(*form, entries)) CHECK(judgement.verdict == Verdict::Right);
                }
    CHECK(n > 300);
    CHECK_FALSE(form_of(two_spans(), CaseId(0), FarEnds::Modified, {.most_blanks = 3}).has_value());
}
