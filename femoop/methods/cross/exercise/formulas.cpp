#include "femoop/methods/cross/exercise/formulas.h"

#include <cmath>

#include "femoop/algebra/dense_solution.h"

namespace femoop::cross {

namespace {

bool is_turned(const Turn& turn, JointId joint) { return !turn || *turn == joint; }

Eigen::VectorXd multipliers(const Eigen::MatrixXd& R, const Eigen::VectorXd& r) { return dense_solution(R, -r); }

} // namespace

Figure Formulas::Unbalance::total() const
{
    Figure sum{.value = -joint_load};
    for (const Line& line : lines) sum = sum + line.figure;
    return sum;
}

std::vector<Figure> Formulas::of(BlankId id) const
{
    const Blank& blank = form_[id];
    const Problem& problem = form_.problem;
    switch (blank.asked) {
    case Asked::Stiffness: return {{problem[blank.end].stiffness / form_.EI}};
    case Asked::Factor: {
        Figure all;
        for (const EndId e : problem[*problem[blank.end].joint].ends) all = all + stiffness(e);
        return {stiffness(blank.end) / all};
    }
    case Asked::FixedEnd: return {fixed_end_formula(blank)};
    case Asked::Balance:
        return {-unbalance(blank).total() * factor(blank.end), -whole_unbalance(blank).total() * factor(blank.end)};
    case Asked::CarryOver: {
        const EndId near = near_end(blank);
        return {problem[near].carry_over * figure(Asked::Balance, blank.sheet, blank.step, near.index, 0.0)};
    }
    case Asked::Sum: {
        Figure all;
        for (const Line& line : lines(blank.sheet, blank.end, 0, form_.turns[blank.sheet].size()))
            all = all + line.figure;
        return {all};
    }
    case Asked::Holding: return {holding_formula(blank)};
    case Asked::Multiplier: return {multiplier_formula(blank)};
    case Asked::Final: return {final_formula(blank)};
    }
    return {};
}

Figure Formulas::figure(Asked asked, std::size_t sheet, std::size_t step, std::size_t which, double otherwise) const
{
    const std::optional<BlankId> blank = form_.find(asked, sheet, step, which);
    if (!blank) return {.value = otherwise};
    return blank->index < figures_.size() ? figures_[blank->index] : Figure{};
}

Figure Formulas::stiffness(EndId end) const
{
    return figure(Asked::Stiffness, 0, 0, end.index, form_.problem[end].stiffness / form_.EI);
}

Figure Formulas::factor(EndId end) const { return figure(Asked::Factor, 0, 0, end.index, form_.problem[end].factor); }

Figure Formulas::fixed_end(std::size_t sheet, EndId end) const
{
    return figure(Asked::FixedEnd, sheet, 0, end.index, form_.loading(sheet).fixed_end[end.index]);
}

Figure Formulas::sum(std::size_t sheet, EndId end) const
{
    if (form_.find(Asked::Sum, sheet, 0, end.index)) return figure(Asked::Sum, sheet, 0, end.index, 0.0);
    return fixed_end(sheet, end);
}

Figure Formulas::holding(std::size_t sheet, std::size_t sway) const
{
    return figure(Asked::Holding, sheet, 0, sway, 0.0);
}

Figure Formulas::multiplier(std::size_t sway) const { return figure(Asked::Multiplier, 0, 0, sway, 0.0); }

// A hinged end takes what an overhang leaves for it, and half of that reaches the other end of its member.
Figure Formulas::fixed_end_formula(const Blank& blank) const
{
    const Problem& problem = form_.problem;
    const auto& right = form_.loading(blank.sheet).fixed_end;
    Figure moment{.value = right[blank.end.index]};
    const auto add_slip = [&](double share, EndId of) {
        if (form_.find(Asked::FixedEnd, blank.sheet, 0, of.index))
            moment = moment + share * (fixed_end(blank.sheet, of) - Figure{.value = right[of.index]});
    };
    const End& end = problem[blank.end];
    if (end.is_hinged) {
        for (std::size_t e = 0; e < problem.ends.size(); ++e)
            if (problem.ends[e].node == end.node && EndId(e) != blank.end) add_slip(-1.0, EndId(e));
    } else if (end.far && problem[*end.far].is_hinged && formula(problem, blank.end) == "3EI/L") {
        add_slip(0.5, *end.far);
    }
    return moment;
}

std::vector<Formulas::Line> Formulas::lines(std::size_t sheet, EndId end, std::size_t first, std::size_t last) const
{
    std::vector<Line> all;
    if (first == 0) all.push_back({Asked::FixedEnd, 0, end, fixed_end(sheet, end)});
    for (std::size_t step = first; step < last; ++step)
        for (const Asked asked : {Asked::Balance, Asked::CarryOver})
            if (form_.find(asked, sheet, step, end.index))
                all.push_back({asked, step, end, figure(asked, sheet, step, end.index, 0.0)});
    return all;
}

std::size_t Formulas::turn_before(const Blank& balance) const
{
    const JointId joint = *form_.problem[balance.end].joint;
    for (std::size_t step = balance.step; step > 0; --step)
        if (is_turned(form_.turns[balance.sheet][step - 1], joint)) return step;
    return 0;
}

Formulas::Unbalance Formulas::unbalance(const Blank& balance) const
{
    const JointId joint = *form_.problem[balance.end].joint;
    const std::size_t before = turn_before(balance);
    Unbalance all{.lines = {}, .is_first = before == 0};
    if (all.is_first) all.joint_load = form_.loading(balance.sheet).joint_load[joint.index];
    for (const EndId e : form_.problem[joint].ends) {
        for (const Line& line : lines(balance.sheet, e, before, balance.step)) all.lines.push_back(line);
        // Where all joints turned at once they carried over after they were balanced.
        if (before == 0) continue;
        if (form_.find(Asked::CarryOver, balance.sheet, before - 1, e.index))
            all.lines.push_back(
                {Asked::CarryOver, before - 1, e, figure(Asked::CarryOver, balance.sheet, before - 1, e.index, 0.0)});
    }
    return all;
}

Formulas::Unbalance Formulas::whole_unbalance(const Blank& balance) const
{
    const JointId joint = *form_.problem[balance.end].joint;
    Unbalance all{.lines = {},
                  .joint_load = form_.loading(balance.sheet).joint_load[joint.index],
                  .is_first = turn_before(balance) == 0};
    for (const EndId e : form_.problem[joint].ends)
        for (const Line& line : lines(balance.sheet, e, 0, balance.step)) all.lines.push_back(line);
    return all;
}

Figure Formulas::holding_formula(const Blank& blank) const
{
    Figure force{.value = form_.bare_holding[blank.sheet][blank.sway]};
    const std::vector<double>& per_moment = form_.holding_per_moment[blank.sheet][blank.sway];
    for (std::size_t e = 0; e < per_moment.size(); ++e)
        if (per_moment[e] != 0.0) force = force + per_moment[e] * sum(blank.sheet, EndId(e));
    return force;
}

Figure Formulas::multiplier_formula(const Blank& blank) const
{
    const auto n = static_cast<Eigen::Index>(form_.problem.sways.size());
    Eigen::MatrixXd R(n, n);
    Eigen::VectorXd r(n);
    Figure x;
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index k = 0; k <= n; ++k) {
            const Figure held = holding(static_cast<std::size_t>(k), static_cast<std::size_t>(j));
            (k == 0 ? r[j] : R(j, k - 1)) = held.value;
            x.is_clean = x.is_clean && held.is_clean;
        }
    const auto own = static_cast<Eigen::Index>(blank.sway);
    x.value = multipliers(R, r)[own];
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index k = 0; k <= n; ++k) {
            Eigen::MatrixXd moved = R;
            Eigen::VectorXd moved_r = r;
            (k == 0 ? moved_r[j]
                    : moved(j, k - 1)) += holding(static_cast<std::size_t>(k), static_cast<std::size_t>(j)).slack;
            x.slack += std::abs(multipliers(moved, moved_r)[own] - x.value);
        }
    return x;
}

Figure Formulas::final_formula(const Blank& blank) const
{
    Figure all = sum(0, blank.end);
    for (std::size_t k = 0; k < form_.problem.sways.size(); ++k) all = all + multiplier(k) * sum(k + 1, blank.end);
    return all;
}

} // namespace femoop::cross
