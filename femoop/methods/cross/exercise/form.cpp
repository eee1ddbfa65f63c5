#include "femoop/methods/cross/exercise/form.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "femoop/methods/cross/exercise/formulas.h"
#include "femoop/methods/cross/virtual_work.h"

namespace femoop::cross {

namespace {

constexpr double by_hand = 0.02;       // of the largest fixed-end moment: where a hand stops
constexpr double no_end_moment = 1e-9; // of the largest
constexpr std::size_t most_loads = 12; // of which each is tried to be forgotten

double largest_end_moment(const std::vector<double>& moments)
{
    double largest = 0.0;
    for (const double moment : moments) largest = std::max(largest, std::abs(moment));
    return largest;
}

/// Lays out the cells in the order in which they are worked.
class FormLayout {
public:
    FormLayout(const Model& model, Form& form, const FormOptions& options)
        : model_(model), form_(form), options_(options)
    {}

    void lay_out()
    {
        const Problem& problem = form_.problem;
        for (std::size_t e = 0; e < problem.ends.size(); ++e)
            if (problem.ends[e].joint) add({.asked = Asked::Stiffness, .end = EndId(e)});
        for (const Joint& joint : problem.joints)
            for (const EndId e : joint.ends)
                if (problem[e].stiffness > 0.0) add({.asked = Asked::Factor, .end = e});
        for (std::size_t sheet = 0; sheet <= problem.sways.size() && !is_full(); ++sheet) lay_out_sheet(sheet);
        if (!problem.sways.empty() && !is_full()) lay_out_superposition();
    }

    bool is_full() const { return form_.blanks.size() > options_.most_blanks; }

private:
    void add(const Blank& blank)
    {
        const bool is_of_sway = blank.asked == Asked::Holding || blank.asked == Asked::Multiplier;
        const std::size_t which = is_of_sway ? blank.sway : blank.end.index;
        form_.places.emplace(Form::Place{blank.asked, blank.sheet, blank.step, which}, BlankId(form_.blanks.size()));
        form_.blanks.push_back(blank);
    }

    void lay_out_sheet(std::size_t sheet)
    {
        const Problem& problem = form_.problem;
        const Loading& loading = form_.loading(sheet);
        add_fixed_ends(sheet);
        Procedure procedure = options_.procedure;
        if (!procedure.tolerance || sheet > 0) procedure.tolerance = by_hand * largest_end_moment(loading.fixed_end);
        procedure.most_steps = options_.most_turns;
        procedure.digits = 0;
        const Sheet worked = try_to_distribute(model_, problem, loading, procedure);
        form_.turns.emplace_back();
        for (const Step& step : worked.steps) {
            form_.turns.back().push_back(step.joint);
            add_turn(sheet, form_.turns.back().size() - 1, step);
            if (is_full()) return;
        }
        for (std::size_t e = 0; e < problem.ends.size(); ++e)
            if (has_lines(sheet, EndId(e))) add({.asked = Asked::Sum, .sheet = sheet, .end = EndId(e)});
    }

    // First overhangs, then the ends that their moments pass, then what those pass on.
    void add_fixed_ends(std::size_t sheet)
    {
        const Problem& problem = form_.problem;
        std::vector<EndId> asked;
        for (std::size_t e = 0; e < problem.ends.size(); ++e)
            if (is_fixed_end_asked(sheet, EndId(e))) asked.emplace_back(e);
        const auto rank = [&](EndId e) { return problem[e].is_overhang ? 0 : problem[e].is_hinged ? 1 : 2; };
        std::ranges::stable_sort(asked, {}, rank);
        for (const EndId e : asked) add({.asked = Asked::FixedEnd, .sheet = sheet, .end = e});
    }

    // A pinned end of a loaded member is asked too: its 0 is worth knowing.
    bool is_fixed_end_asked(std::size_t sheet, EndId id) const
    {
        const std::vector<double>& moments = form_.loading(sheet).fixed_end;
        const End& end = form_.problem[id];
        const double least = no_end_moment * largest_end_moment(moments);
        const auto has_moment = [&](EndId e) { return std::abs(moments[e.index]) > least; };
        return has_moment(id) || (end.far && !end.is_overhang && has_moment(*end.far));
    }

    void add_turn(std::size_t sheet, std::size_t turn, const Step& step)
    {
        const Problem& problem = form_.problem;
        std::vector<EndId> turned;
        for (std::size_t j = 0; j < problem.joints.size(); ++j)
            if (!step.joint || step.joint->index == j)
                for (const EndId e : problem.joints[j].ends)
                    if (problem[e].stiffness > 0.0) turned.push_back(e);
        for (const EndId e : turned) add({.asked = Asked::Balance, .sheet = sheet, .step = turn, .end = e});
        for (const EndId e : turned)
            if (const auto far = problem[e].far; far && !problem[e].is_overhang)
                add({.asked = Asked::CarryOver,
                     .sheet = sheet,
                     .step = turn,
                     .end = *far,
                     .may_stay_empty = problem[e].carry_over == 0.0});
    }

    bool has_lines(std::size_t sheet, EndId end) const
    {
        for (std::size_t step = 0; step < form_.turns[sheet].size(); ++step) {
            if (form_.find(Asked::Balance, sheet, step, end.index)) return true;
            const auto carried = form_.find(Asked::CarryOver, sheet, step, end.index);
            if (carried && !form_[*carried].may_stay_empty) return true;
        }
        return false;
    }

    void lay_out_superposition()
    {
        const Problem& problem = form_.problem;
        const std::size_t n = problem.sways.size();
        for (std::size_t sheet = 0; sheet <= n; ++sheet)
            for (std::size_t sway = 0; sway < n; ++sway) add({.asked = Asked::Holding, .sheet = sheet, .sway = sway});
        for (std::size_t sway = 0; sway < n; ++sway) add({.asked = Asked::Multiplier, .sway = sway});
        for (std::size_t e = 0; e < problem.ends.size(); ++e) {
            bool is_asked = false;
            for (std::size_t sheet = 0; sheet <= n; ++sheet)
                is_asked = is_asked || form_.find(Asked::Sum, sheet, 0, e) || form_.find(Asked::FixedEnd, sheet, 0, e);
            if (is_asked && !problem.ends[e].is_hinged) add({.asked = Asked::Final, .end = EndId(e)});
        }
    }

    const Model& model_;
    Form& form_;
    const FormOptions& options_;
};

/// The forces of the props without end moments, and what each end moment adds: they are linear in them.
void find_holding(Form& form)
{
    const Problem& problem = form.problem;
    const std::vector<double> no_rotation(problem.joints.size(), 0.0);
    for (std::size_t sheet = 0; sheet <= problem.sways.size(); ++sheet) {
        const auto held = [&](const std::vector<double>& at_end) {
            const Moments moments{at_end, no_rotation};
            return sheet == 0 ? holding_forces(problem, moments)
                              : holding_forces(problem, moments, problem.sways[sheet - 1]);
        };
        std::vector<double> moments(problem.ends.size(), 0.0);
        const std::vector<double> bare = held(moments);
        std::vector<std::vector<double>> shares(bare.size(), moments);
        for (std::size_t e = 0; e < moments.size(); ++e) {
            moments[e] = 1.0;
            const std::vector<double> with_one = held(moments);
            moments[e] = 0.0;
            for (std::size_t j = 0; j < bare.size(); ++j)
                if (std::abs(with_one[j] - bare[j]) > 1e-12 * std::abs(bare[j])) shares[j][e] = with_one[j] - bare[j];
        }
        form.bare_holding.push_back(bare);
        form.holding_per_moment.push_back(std::move(shares));
    }
}

/// What the same structure has when every joint is locked, pins too.
void find_plain(Form& form, const Model& model, CaseId load_case)
{
    const Problem plain = problem_of(model, load_case, FarEnds::Plain);
    for (const End& end : plain.ends) form.plain_stiffness.push_back(end.stiffness / form.EI);
    form.plain_fixed_end.push_back(plain.loading.fixed_end);
    for (std::size_t k = 0; k < form.problem.sways.size(); ++k) {
        const Sway &sway = form.problem.sways[k], &other = plain.sways.at(k);
        form.plain_fixed_end.push_back(other.loading.fixed_end);
        for (double& moment : form.plain_fixed_end.back()) moment *= sway.scale / other.scale;
    }
}

void find_forgotten_loads(Form& form, const Model& model, CaseId load_case)
{
    if (load_case.index >= model.load_cases.size()) return;
    const std::vector<MemberLoad>& loads = model.load_cases[load_case.index].members;
    for (std::size_t i = 0; i < loads.size() && form.without.size() < most_loads; ++i) {
        if (std::ranges::count(loads, loads[i].member, &MemberLoad::member) < 2) continue;
        Model lighter = model;
        auto& left = lighter.load_cases[load_case.index].members;
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        form.without.push_back(
            {loads[i].member, problem_of(lighter, load_case, form.problem.far_ends).loading.fixed_end});
    }
}

MemberId slenderest_member(const Problem& problem)
{
    MemberId slenderest;
    double least_stiffness = std::numeric_limits<double>::infinity();
    for (std::size_t m = 0; m < problem.members.size(); ++m) {
        const double EI = problem.members[m].EI_over_L * problem.members[m].length;
        if (EI > 0.0 && EI < least_stiffness * (1.0 - 1e-9)) slenderest = MemberId(m), least_stiffness = EI;
    }
    return slenderest;
}

void fill_right(Form& form)
{
    std::vector<Figure> figures;
    const Formulas formulas(form, figures);
    for (std::size_t i = 0; i < form.blanks.size(); ++i) {
        figures.push_back(formulas.of(BlankId(i)).front());
        form.right.push_back(figures.back().value);
    }
}

} // namespace

std::optional<BlankId> Form::find(Asked asked, std::size_t sheet, std::size_t step, std::size_t which) const
{
    const auto at = places.find({asked, sheet, step, which});
    return at == places.end() ? std::nullopt : std::optional(at->second);
}

bool is_for_hand(const Problem& problem)
{
    return std::ranges::none_of(problem.members,
                                [](const MemberAction& member) { return member.has_foundation || member.is_tapered; });
}

std::optional<Form> form_of(const Model& model, CaseId load_case, FarEnds far_ends, const FormOptions& options)
{
    Form form{.problem = problem_of(model, load_case, far_ends)};
    if (!is_for_hand(form.problem)) return std::nullopt;
    form.slenderest = slenderest_member(form.problem);
    if (form.slenderest.index < form.problem.members.size()) {
        const MemberAction& unit = form.problem.members[form.slenderest.index];
        if (unit.EI_over_L > 0.0) form.EI = unit.EI_over_L * unit.length;
    }
    FormLayout layout(model, form, options);
    layout.lay_out();
    if (layout.is_full()) return std::nullopt;
    find_plain(form, model, load_case);
    find_forgotten_loads(form, model, load_case);
    find_holding(form);
    fill_right(form);
    return form;
}

} // namespace femoop::cross
