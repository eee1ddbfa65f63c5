#include "femoop/io/cross/sheet_check.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace femoop::cross {

namespace {

constexpr double round_off_of_rows = 1e-9; // of the largest of several numbers
constexpr std::string_view names_of_rows[] = {"FEM", "BAL", "CO", "TOTAL"};

double largest_of(const std::vector<double>& values)
{
    double largest = 0.0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

} // namespace

double nearer_to(double wanted, double a, double b) { return std::abs(a - wanted) <= std::abs(b - wanted) ? a : b; }

SheetCheck::SheetCheck(const Model& model, const Block& block, const Problem& problem, const Translator& tr)
    : model_(model), block_(block), problem_(problem), tr_(tr), procedure_(procedure_of(model, problem, block))
{}

SheetCheck::Tolerance SheetCheck::of_exact(double largest) const
{
    return {.absolute = round_off_of_rows * largest, .relative = block_.rtol};
}

/// Half a unit of the last digit that the file writes.
double SheetCheck::half_a_digit(double value) const
{
    if (block_.digits <= 0 || value == 0.0) return 0.0;
    return 0.5 * std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1.0 - block_.digits);
}

CheckOutcome SheetCheck::compared(const std::string& what, double wanted, double found, Tolerance within) const
{
    return femoop::compared(what, wanted, found,
                            std::max({within.absolute, within.relative * std::abs(wanted), half_a_digit(wanted)}));
}

void SheetCheck::number(const std::string& what, double wanted, double found, double largest)
{
    outcomes_.push_back(compared(what, wanted, found, of_exact(largest)));
    outcomes_.back().magnitude = largest;
}

void SheetCheck::row(const std::string& what, const Labelled& wanted, const std::vector<double>& values,
                     Tolerance within)
{
    if (wanted.empty()) return;
    CheckOutcome worst;
    double worst_excess = -1.0;
    for (const auto& [end, value] : by_end(problem_, wanted, what)) {
        CheckOutcome one = compared(fill(tr_("{0}: {1}"), {what, problem_[end].label}), value, values[end.index],
                                    within);
        const double off = std::abs(values[end.index] - value);
        const double excess = one.tolerance > 0.0 ? off / one.tolerance : off;
        const bool is_worse = one.verdict == Verdict::Failed && worst.verdict != Verdict::Failed;
        if (!is_worse && !(excess > worst_excess)) continue;
        worst_excess = excess;
        worst = std::move(one);
    }
    worst.magnitude = largest_of(values);
    outcomes_.push_back(std::move(worst));
}

void SheetCheck::row(const std::string& what, const Labelled& wanted, const Exact& values)
{
    std::vector<double> nearer = values.strained;
    for (const auto& [end, value] : by_end(problem_, wanted, what))
        nearer[end.index] = nearer_to(value, values.strained[end.index], values.unstrained[end.index]);
    row(what, wanted, nearer, of_exact(largest_of(values.strained)));
}

Sheet SheetCheck::worked(const Problem& half, const Loading& loading, const std::vector<Block::Row>& wanted) const
{
    Procedure procedure = procedure_;
    const bool is_own_count = !block_.balances || !block_.stages.empty();
    if (is_own_count && wanted.size() > 1) {
        procedure.balances = std::ranges::count(wanted, "BAL", &Block::Row::step);
        procedure.ends_with_balance = wanted[wanted.size() - 2].step == "BAL";
    }
    return try_to_distribute(model_, half, loading, procedure);
}

void SheetCheck::sheet(const std::vector<Block::Row>& wanted, const Problem& half, const Sheet& sheet,
                       const Place& place)
{
    const std::vector<Row> rows = rows_of(half, sheet);
    if (rows.size() != wanted.size())
        throw ModelError({{FaultKind::CrossSheetTooLong,
                           {place.in_file, std::to_string(wanted.size()), std::to_string(rows.size())}}});
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::string_view step = names_of_rows[static_cast<std::size_t>(rows[i].kind)];
        row(fill(tr_("{0}: row {1} {2}"), {place.in_words, std::to_string(i + 1), std::string(step)}), wanted[i].values,
            rows[i].values, of_sheet());
        if (wanted[i].step != step && !wanted[i].values.empty()) outcomes_.back().verdict = Verdict::Failed;
    }
}

} // namespace femoop::cross
