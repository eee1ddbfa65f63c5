#include "femoop/io/cross/cross_table.h"

#include "femoop/io/cross/half_text.h"
#include "femoop/methods/cross/fraction.h"
#include "femoop/methods/cross/rounding.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/tabular/plain_text.h"

namespace femoop::cross {

namespace {

constexpr int shown_digits = 4;

class SheetText {
public:
    SheetText(const Worked& worked, const Translator& tr) : worked_(worked), problem_(worked.problem), tr_(tr) {}

    std::string write() const
    {
        std::string text = heading();
        if (problem_.halves.empty()) text += factors(problem_) + "\n";
        text += title_of_loads() + "\n" + sheet(0, problem_.loading, worked_.all.held.sheet);
        for (std::size_t k = 0; k < problem_.sways.size(); ++k) text += sway(k);
        if (!problem_.sways.empty()) text += equations();
        return text + finals();
    }

private:
    std::string print(const tabular::Table& table) const
    {
        return tabular::plain_text(table, {.decimal_mark = decimal_mark(tr_)});
    }
    std::string number(double value) const { return localized(number_text(rounded(value, shown_digits)), tr_); }
    std::string moment(double value) const
    {
        return localized(number_text(rounded(value, shown_digits)), tr_) + " " + unit();
    }
    const std::string& name(NodeId node) const { return worked_.model[node].id; }

    std::string heading() const
    {
        const std::string& title = worked_.model.title;
        return (title.empty() ? "" : printable(title) + "\n") +
               fill(tr_("Moment distribution, case {0}: moments on the member ends in {1}, counter-clockwise positive"),
                    {worked_.model.case_name(problem_.load_case), unit()}) +
               "\n\n";
    }

    std::string unit() const { return printed_unit(dimension::moment, worked_.model.units); }

    std::string factors(const Problem& half) const
    {
        tabular::Table table(
            {tr_("member end"), tr_("stiffness"), "", tr_("distribution factor"), "", tr_("carry-over")});
        for (std::size_t e = 0; e < half.ends.size(); ++e) {
            if (!half.is_on_sheet(EndId(e))) continue;
            const End& end = half.ends[e];
            const auto fraction = fraction_of(end.factor, 999);
            const bool is_on_axis = end.joint && !half.is_balanced(*end.joint);
            const bool is_free = (end.joint && !is_on_axis) || end.is_hinged;
            table.add_row({end.label, std::string(formula(half, EndId(e))), number(end.stiffness),
                           is_free      ? number(end.factor)
                           : is_on_axis ? tr_("on the axis")
                                        : tr_("fixed"),
                           is_free && fraction ? fraction_text(*fraction) : std::string(), number(end.carry_over)});
        }
        return print(table);
    }

    std::string title_of_loads() const
    {
        if (problem_.sways.empty()) return tr_("Sheet");
        return tr_("Sheet of the loads, every sway held by a prop");
    }

    std::string word(RowKind kind) const
    {
        static constexpr std::string_view words[] = {translatable("FEM"), translatable("BAL"), translatable("CO"),
                                                     translatable("TOTAL")};
        return tr_(words[static_cast<std::size_t>(kind)]);
    }

    std::string sheet(std::size_t stage, const Loading& loading, const Sheet& sheet) const
    {
        const Problem& half = problem_.of_sheet(stage);
        std::vector<tabular::Column> headers{tr_("step"), tr_("joint")};
        for (std::size_t e = 0; e < half.ends.size(); ++e)
            if (half.is_on_sheet(EndId(e))) headers.push_back(half.ends[e].label);
        tabular::Table table(headers);
        for (const Row& row : rows_of(half, sheet)) {
            std::vector<tabular::Cell> cells{word(row.kind), row.joint ? name(problem_[*row.joint].node) : ""};
            for (std::size_t e = 0; e < row.values.size(); ++e)
                if (half.is_on_sheet(EndId(e))) cells.emplace_back(row.values[e]);
            table.add_row(std::move(cells));
        }
        return reasons(half) + print(table) + summary(half, sheet) + drift_line(half, loading, sheet);
    }

    std::string reasons(const Problem& half) const
    {
        if (!half.mirror) return "";
        std::string text;
        for (const std::string& sentence : half_text(worked_.model, half, tr_)) text += sentence + "\n";
        return text + "\n" + factors(half) + "\n";
    }

    std::string summary(const Problem& half, const Sheet& sheet) const
    {
        std::string text = fill(tr_("balances: {0}; largest unbalance left: {1}"),
                                {std::to_string(sheet.steps.size()), moment(largest_unbalance(sheet.end))});
        if (const auto per_round = rate(half, sheet))
            text += "; " + fill(tr_("each round leaves {0} of it"), {number(*per_round)});
        return text + "\n";
    }

    std::string drift_line(const Problem& half, const Loading& loading, const Sheet& sheet) const
    {
        if (worked_.procedure.digits == 0) return "";
        double largest = 0.0;
        for (const double one : drift(half, loading, sheet)) largest = std::max(largest, std::abs(one));
        return fill(tr_("rounding to {0} digits moved the totals by {1} at most"),
                    {std::to_string(worked_.procedure.digits), moment(largest)}) +
               "\n";
    }

    std::string sway(std::size_t k) const
    {
        const Sway& one = problem_.sways[k];
        return "\n" +
               fill(tr_("Sheet of sway {0}: node {1} moves by {2}"),
                    {std::to_string(k + 1), name(one.prop),
                     localized(quantity_text(rounded(one.scale, shown_digits), dimension::length, worked_.model.units),
                               tr_)}) +
               "\n" + sheet(k + 1, one.loading, worked_.all.sways[k].sheet);
    }

    /// The forces of the props in every sheet, and how much of each sway lets them vanish.
    std::string equations() const
    {
        std::vector<tabular::Column> headers{tr_("prop at"), tr_("loads")};
        for (std::size_t k = 0; k < problem_.sways.size(); ++k)
            headers.push_back(fill(tr_("sway {0}"), {std::to_string(k + 1)}));
        headers.push_back(tr_("multiplier"));
        tabular::Table table(headers);
        for (Eigen::Index j = 0; j < worked_.all.R.rows(); ++j) {
            std::vector<tabular::Cell> cells{name(problem_.sways[static_cast<std::size_t>(j)].prop),
                                             -worked_.all.r[j] + 0.0};
            for (const double r : worked_.all.R.row(j)) cells.emplace_back(r);
            cells.emplace_back(worked_.all.x[j]);
            table.add_row(std::move(cells));
        }
        return "\n" + tr_("Forces of the props; so many times each sway they vanish") + "\n" + print(table) +
               sways_that_are_none();
    }

    std::string sways_that_are_none() const
    {
        std::string text;
        for (std::size_t k = 0; k < problem_.sways.size(); ++k)
            if (worked_.all.x[static_cast<Eigen::Index>(k)] == 0.0)
                text += fill(tr_("the loads cause no sway at {0}"), {name(problem_.sways[k].prop)}) + "\n";
        return text;
    }

    std::string finals() const
    {
        tabular::Table table(
            {tr_("member end"), tr_("distributed"), tr_("its limit"), tr_("stiffness method"), tr_("difference")});
        const Comparison& all = worked_.comparison;
        for (std::size_t e = 0; e < problem_.ends.size(); ++e)
            table.add_row({problem_.ends[e].label, all.distributed[e], all.limit[e], all.stiffness[e], all.apart[e]});
        const std::string title = problem_.halves.empty() ? tr_("Final moments")
                                                          : tr_("Final moments of the whole structure");
        return "\n" + title + "\n" + print(table);
    }

    const Worked& worked_;
    const Problem& problem_;
    const Translator& tr_;
};

} // namespace

std::string sheet_text(const Worked& worked, const Translator& tr) { return SheetText(worked, tr).write(); }

} // namespace femoop::cross
