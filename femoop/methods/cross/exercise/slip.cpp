#include "femoop/methods/cross/exercise/slip.h"

#include <algorithm>
#include <cmath>

namespace femoop::cross {

namespace {

/// Gathers the mistakes of one cell.
class Finder {
public:
    Finder(const Form& form, const std::vector<Figure>& figures, BlankId id)
        : form_(form), problem_(form.problem), formulas_(form, figures), blank_(form[id]), id_(id)
    {}

    std::vector<SlipFigure> find()
    {
        switch (blank_.asked) {
        case Asked::Stiffness: stiffness(); break;
        case Asked::Factor: factor(); break;
        case Asked::FixedEnd: fixed_end(); break;
        case Asked::Balance: balance(); break;
        case Asked::CarryOver: carry_over(); break;
        case Asked::Sum: sum(); break;
        case Asked::Holding: holding(); break;
        case Asked::Multiplier: multiplier(); break;
        case Asked::Final: final_moment(); break;
        }
        return std::move(all_);
    }

private:
    void add(Slip slip, const Figure& figure) { all_.push_back({slip, figure}); }
    void add(Slip slip, double value) { add(slip, Figure{.value = value}); }
    Figure own() const { return formulas_.of(id_).front(); }
    const End& end() const { return problem_[blank_.end]; }
    const std::vector<EndId>& ends_of_joint() const { return problem_[*end().joint].ends; }

    /// The ends at the joint that resist its rotation, this one aside.
    std::vector<EndId> others() const
    {
        std::vector<EndId> found;
        for (const EndId e : ends_of_joint())
            if (e != blank_.end && problem_[e].stiffness > 0.0) found.push_back(e);
        return found;
    }

    // ---- stiffness and factors

    void stiffness()
    {
        if (!end().member) return add(Slip::OppositeSign, -own());
        const MemberAction& member = problem_.members[end().member->index];
        const double one = member.EI_over_L / form_.EI; // EI/L
        const std::string_view text = formula(problem_, blank_.end);
        if (text == "0") {
            for (const double times : {4.0, 3.0}) add(Slip::FreeEndStiff, times * one);
            return;
        }
        add(Slip::OppositeSign, -own());
        if (text == "3EI/L") add(Slip::PinnedAsFixed, 4.0 * one);
        if (text == "4EI/L") add(Slip::FixedAsPinned, 3.0 * one);
        for (const double times : {1.0, 2.0}) add(Slip::BareStiffness, times * one);
        add(Slip::NoLength, member.length * own());
        for (const MemberAction& other : problem_.members)
            if (other.EI_over_L > 0.0)
                add(Slip::OtherEI, own().value * other.EI_over_L * other.length / (member.EI_over_L * member.length));
    }

    void factor()
    {
        const Figure own_k = formulas_.stiffness(blank_.end);
        Figure all = own_k, flexible = Figure{.value = 1.0} / own_k;
        for (const EndId o : others()) {
            all = all + formulas_.stiffness(o);
            flexible = flexible + Figure{.value = 1.0} / formulas_.stiffness(o);
        }
        for (const EndId o : others()) {
            add(Slip::ExchangedFactor, formulas_.stiffness(o) / all);
            add(Slip::RatioOfTwo, own_k / formulas_.stiffness(o));
            add(Slip::RatioOfTwo, formulas_.stiffness(o) / own_k);
        }
        add(Slip::InvertedFactor, (Figure{.value = 1.0} / own_k) / flexible);
        add(Slip::InvertedFactor, all / own_k);
        add(Slip::SharedWithOthers, own_k / all_stiffness());
        add(Slip::EqualShares, 1.0 / static_cast<double>(others().size() + 1));
        add(Slip::UnmodifiedFactor, unmodified_factor());
        add(Slip::OppositeSign, -own());
        add(Slip::Percent, 100.0 * own());
    }

    Figure all_stiffness() const
    {
        Figure all;
        for (const Joint& joint : problem_.joints)
            for (const EndId e : joint.ends) all = all + formulas_.stiffness(e);
        return all;
    }

    double unmodified_factor() const
    {
        double all = form_.plain_stiffness[blank_.end.index];
        for (const EndId o : others()) all += form_.plain_stiffness[o.index];
        return form_.plain_stiffness[blank_.end.index] / all;
    }

    // ---- fixed-end moments

    void fixed_end()
    {
        const std::vector<double>& moments = form_.loading(blank_.sheet).fixed_end;
        const double right = moments[blank_.end.index], plain = plain_fixed_end();
        add(Slip::OppositeSign, -own());
        if (!end().far) return;
        const double far = moments[end().far->index];
        if (end().is_hinged) {
            add(Slip::PinnedEndHolds, plain);
            add(Slip::PinnedEndHolds, -plain);
            return;
        }
        if (std::abs(plain - right) > 1e-9 * std::abs(plain))
            for (const double sign : {1.0, -1.0}) add(Slip::PinnedAsFixed, sign * plain);
        if (!problem_[*end().far].is_hinged && !end().is_overhang) add_fixed_as_pinned(right, far);
        if (std::abs(far) > 0.0) add(Slip::OtherEnd, -far);
        if (std::abs(std::abs(far) - std::abs(right)) > 1e-9 * std::abs(right) && far != 0.0) add(Slip::OtherEnd, far);
        if (problem_[*end().far].is_hinged) add(Slip::OverhangForgotten, right - 0.5 * far);
        for (const WithoutLoad& less : form_.without)
            if (blank_.sheet == 0 && less.member == *end().member)
                add(Slip::LoadForgotten, less.fixed_end[blank_.end.index]);
    }

    double plain_fixed_end() const { return form_.plain_fixed_end[blank_.sheet][blank_.end.index]; }

    void add_fixed_as_pinned(double right, double far)
    {
        const double share = problem_[*end().far].carry_over;
        if (share == 0.0) return;
        for (const double sign : {1.0, -1.0}) add(Slip::FixedAsPinned, sign * (right - share * far));
    }

    // ---- balances and what they carry over

    void balance()
    {
        const Formulas::Unbalance present = formulas_.unbalance(blank_);
        const Figure total = present.total(), mu = formulas_.factor(blank_.end);
        add(Slip::BalanceNotReversed, total * mu);
        for (const EndId o : others()) add(Slip::OtherFactor, -total * formulas_.factor(o));
        add(Slip::NotShared, -total);
        leave_out(present, mu);
        if (present.joint_load != 0.0)
            for (const double times : {1.0, 2.0})
                add(Slip::JointLoadForgotten, -(total + Figure{.value = times * present.joint_load}) * mu);
        if (present.is_first) return;
        Figure again;
        for (const Formulas::Line& line : formulas_.whole_unbalance(blank_).lines)
            if (line.asked != Asked::Balance) again = again + line.figure;
        add(Slip::CountedAgain, -again * mu);
    }

    /// Each number that acts on the joint, and all carry-overs together.
    void leave_out(const Formulas::Unbalance& present, const Figure& mu)
    {
        const Figure total = present.total();
        Figure carried;
        for (const Formulas::Line& line : present.lines) {
            if (line.asked == Asked::CarryOver) carried = carried + line.figure;
            const Slip slip = line.asked == Asked::FixedEnd ? Slip::MomentNotCounted : Slip::CarryOverNotCounted;
            add(slip, -(total - line.figure) * mu);
        }
        add(Slip::CarryOverNotCounted, -(total - carried) * mu);
    }

    void carry_over()
    {
        const EndId near = formulas_.near_end(blank_);
        const auto balance_of = [&](EndId e) {
            for (const Formulas::Line& line : formulas_.lines(blank_.sheet, e, blank_.step, blank_.step + 1))
                if (line.asked == Asked::Balance) return line.figure;
            return Figure{};
        };
        const Figure given = balance_of(near);
        if (blank_.may_stay_empty) {
            for (const double share : {0.5, 1.0, -0.5, -1.0}) add(Slip::CarriedToPinnedEnd, share * given);
            return;
        }
        const double share = problem_[near].carry_over;
        add(Slip::CarryOverForgotten, 0.0);
        add(Slip::CarriedWhole, given);
        add(Slip::CarriedWithOtherSign, -share * given);
        for (const EndId o : problem_[*problem_[near].joint].ends)
            if (o != near && problem_[o].stiffness > 0.0) add(Slip::CarriedFromOther, share * balance_of(o));
    }

    void sum()
    {
        const Figure total = own();
        add(Slip::OppositeSign, -total);
        Figure carried;
        for (const Formulas::Line& line : formulas_.lines(blank_.sheet, blank_.end, 0, n_turns())) {
            add(Slip::LineForgotten, total - line.figure);
            if (line.asked == Asked::CarryOver) carried = carried + line.figure;
        }
        add(Slip::LineForgotten, total - carried);
    }

    std::size_t n_turns() const { return form_.turns[blank_.sheet].size(); }

    // ---- sways

    void holding()
    {
        const Figure right = own();
        add(Slip::OppositeSign, -right);
        const std::vector<double>& per_moment = form_.holding_per_moment[blank_.sheet][blank_.sway];
        for (const MemberAction& member : problem_.members) {
            Figure shear;
            for (const auto& e : member.ends)
                if (e) shear = shear + per_moment[e->index] * formulas_.sum(blank_.sheet, *e);
            add(Slip::MemberForgotten, right - shear);
        }
        const double bare = form_.bare_holding[blank_.sheet][blank_.sway];
        if (bare != 0.0) add(Slip::LoadsForgotten, right - Figure{.value = bare});
    }

    void multiplier()
    {
        const Figure right = own();
        add(Slip::OppositeSign, -right);
        if (problem_.sways.size() > 1) return;
        const Figure turned_over = Figure{.value = 1.0} / right;
        add(Slip::MultiplierInverted, turned_over);
        add(Slip::MultiplierInverted, -turned_over);
    }

    void final_moment()
    {
        const Figure held = formulas_.sum(0, blank_.end);
        Figure scaled, plain;
        for (std::size_t k = 0; k < problem_.sways.size(); ++k) {
            const Figure sway = formulas_.sum(k + 1, blank_.end);
            scaled = scaled + formulas_.multiplier(k) * sway;
            plain = plain + sway;
        }
        add(Slip::SwayForgotten, held);
        add(Slip::SwaySubtracted, held - scaled);
        add(Slip::SwayNotScaled, held + plain);
        add(Slip::OppositeSign, -own());
        add(Slip::LoadsForgotten, scaled);
    }

    const Form& form_;
    const Problem& problem_;
    Formulas formulas_;
    const Blank& blank_;
    BlankId id_;
    std::vector<SlipFigure> all_;
};

} // namespace

std::vector<SlipFigure> slips_of(const Form& form, const std::vector<Figure>& figures, BlankId id)
{
    return Finder(form, figures, id).find();
}

} // namespace femoop::cross
