#include "femoop/io/cross/cross_check.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "femoop/analysis/linear_static.h"
#include "femoop/methods/cross/state_model.h"
#include "femoop/methods/cross/virtual_work.h"

namespace femoop::cross {

namespace {

constexpr double round_off = 1e-9; // of the largest of several numbers
constexpr std::string_view step_names[] = {"FEM", "BAL", "CO", "TOTAL"};

class BlockCheck {
public:
    BlockCheck(const Model& model, const Block& block, const Translator& tr)
        : model_(model),
          block_(block),
          tr_(tr),
          load_case_(case_of(model, block)),
          problem_(problem_of(model, load_case_, far_ends_of(model, load_case_, block), extent_of(block))),
          procedure_(procedure_of(model, problem_, block))
    {}

    std::vector<CheckOutcome> run()
    {
        check_factors();
        check_row(tr_("cross: fixed-end moments"), block_.fixed_end, problem_.loading.fixed_end, tolerance());
        const Problem& half = problem_.of_sheet(0);
        if (!block_.sheet.empty())
            check_sheet(block_.sheet, half, worked(half, problem_.loading, block_.sheet), tr_("cross"));
        check_stages();
        check_final();
        return std::move(outcomes_);
    }

private:
    struct Tolerance {
        double absolute = 0.0, relative = 0.0;
    };
    Tolerance tolerance() const { return {.absolute = block_.sheet_atol}; }

    /// Half a unit of the last digit that the file writes.
    double half_a_digit(double value) const
    {
        if (block_.digits <= 0 || value == 0.0) return 0.0;
        return 0.5 * std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1.0 - block_.digits);
    }

    /// Worked as far as the file's sheet goes.
    Sheet worked(const Problem& half, const Loading& loading, const std::vector<Block::Row>& wanted) const
    {
        Procedure procedure = procedure_;
        const bool is_own_count = !block_.balances || !block_.stages.empty();
        if (is_own_count && wanted.size() > 1) {
            procedure.balances = std::ranges::count(wanted, "BAL", &Block::Row::step);
            procedure.ends_with_balance = wanted[wanted.size() - 2].step == "BAL";
        }
        return try_to_distribute(model_, half, loading, procedure);
    }

    /// One check of several values: that of the end which is furthest off.
    void check_row(const std::string& what, const Labelled& wanted, const std::vector<double>& values, Tolerance within)
    {
        if (wanted.empty()) return;
        CheckOutcome worst;
        double worst_excess = -1.0;
        for (const auto& [end, value] : by_end(problem_, wanted, what)) {
            CheckOutcome one{
                .what = fill(tr_("{0}: {1}"), {what, problem_[end].label}),
                .verdict = Verdict::Passed,
                .expected = value,
                .result = values[end.index],
                .tolerance = std::max({within.absolute, within.relative * std::abs(value), half_a_digit(value)}),
                .skipped = {}};
            const double off = std::abs(values[end.index] - value);
            if (!(off <= one.tolerance)) one.verdict = Verdict::Failed;
            const double excess = one.tolerance > 0.0 ? off / one.tolerance : off;
            if (!(excess > worst_excess)) continue;
            worst_excess = excess;
            worst = std::move(one);
        }
        outcomes_.push_back(std::move(worst));
    }

    void check_factors()
    {
        const std::vector<double> factors = factors_of(problem_.of_sheet(0), block_.digits);
        for (const auto& [joint, wanted] : block_.factors)
            check_row(fill(tr_("cross: factors of {0}"), {joint}), wanted, factors, tolerance());
    }

    void check_sheet(const std::vector<Block::Row>& wanted, const Problem& half, const Sheet& sheet,
                     const std::string& whose)
    {
        const std::vector<Row> rows = rows_of(half, sheet);
        if (rows.size() != wanted.size())
            throw ModelError({{FaultKind::CrossSheetTooLong,
                               {"cross.sheet", std::to_string(wanted.size()), std::to_string(rows.size())}}});
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::string_view step = step_names[static_cast<std::size_t>(rows[i].kind)];
            check_row(fill(tr_("{0}: row {1} {2}"), {whose, std::to_string(i + 1), std::string(step)}),
                      wanted[i].values, rows[i].values, tolerance());
            if (wanted[i].step != step && !wanted[i].values.empty()) outcomes_.back().verdict = Verdict::Failed;
        }
    }

    /// The sway whose prop holds a node; where none is named the one that is expected there.
    std::optional<std::size_t> sway_at(const std::optional<std::string>& node, std::size_t expected) const
    {
        if (!node) return expected < problem_.sways.size() ? std::optional(expected) : std::nullopt;
        const auto is_it = [&](const Sway& sway) { return model_[sway.prop].id == *node; };
        const auto found = std::ranges::find_if(problem_.sways, is_it);
        if (found == problem_.sways.end()) return std::nullopt;
        return static_cast<std::size_t>(found - problem_.sways.begin());
    }

    void skip(const std::string& whose) { outcomes_.push_back({.what = whose, .skipped = SkipReason::SheetNotBuilt}); }

    /// A sheet with the props, then each sway alone, as much of it as the file moves.
    void check_stages()
    {
        std::size_t n_sways = 0;
        for (std::size_t i = 0; i < block_.stages.size(); ++i) {
            const Block::Stage& stage = block_.stages[i];
            const std::string whose = fill(tr_("cross: stage {0}"), {std::to_string(i + 1)});
            if (!stage.props.empty()) {
                check_stage(whose, stage, problem_.of_sheet(0), problem_.loading);
                continue;
            }
            if (const auto sway = sway_at(stage.sway, n_sways++))
                check_stage(whose, stage, problem_.of_sheet(*sway + 1), scaled(problem_.sways[*sway], stage).loading);
            else skip(whose);
        }
    }

    void check_stage(const std::string& whose, const Block::Stage& stage, const Problem& half, const Loading& loading)
    {
        check_row(fill(tr_("{0}: fixed-end moments"), {whose}), stage.fixed_end, loading.fixed_end, tolerance());
        const Sheet sheet = worked(half, loading, stage.sheet);
        if (!stage.sheet.empty()) check_sheet(stage.sheet, half, sheet, whose);
        for (std::size_t k = 0; k < stage.props.size(); ++k)
            if (const auto sway = sway_at(stage.props[k].node, k))
                check_prop(whose, stage.props[k].reaction, sheet.end, *sway);
            else skip(whose);
    }

    Sway scaled(Sway sway, const Block::Stage& stage) const
    {
        const Labelled& wanted = stage.fixed_end.empty() && !stage.sheet.empty() ? stage.sheet.front().values
                                                                                 : stage.fixed_end;
        double over = 0.0, under = 0.0;
        for (const auto& [end, value] : by_end(problem_, wanted, "cross.stages")) {
            over += value * sway.loading.fixed_end[end.index];
            under += sway.loading.fixed_end[end.index] * sway.loading.fixed_end[end.index];
        }
        const double times = over == 0.0 || under == 0.0 ? 1.0 : over / under;
        sway.scale *= times;
        for (double& moment : sway.loading.fixed_end) moment *= times;
        return sway;
    }

    void check_prop(const std::string& whose, double wanted, const State& state, std::size_t sway)
    {
        const double held = holding_forces(problem_, {state.moments, state.rotations})[sway];
        CheckOutcome one{
            .what = fill(tr_("{0}: force of the prop"), {whose}),
            .verdict = Verdict::Passed,
            .expected = wanted,
            .result = held,
            .tolerance = std::max({block_.sheet_atol, block_.rtol * std::abs(wanted), half_a_digit(wanted)}),
            .skipped = {}};
        if (!(std::abs(held - wanted) <= one.tolerance)) one.verdict = Verdict::Failed;
        outcomes_.push_back(std::move(one));
    }

    void check_final()
    {
        if (block_.last.empty()) return;
        const std::vector<double> moments = end_moments(model_, problem_, analyse(model_)[load_case_]);
        double largest = 0.0;
        for (const double moment : moments) largest = std::max(largest, std::abs(moment));
        for (const auto& wanted : block_.last)
            check_row(tr_("cross: final"), {wanted}, moments,
                      {.absolute = round_off * largest, .relative = block_.rtol});
    }

    const Model& model_;
    const Block& block_;
    const Translator& tr_;
    CaseId load_case_;
    Problem problem_;
    Procedure procedure_;
    std::vector<CheckOutcome> outcomes_;
};

} // namespace

std::vector<CheckOutcome> check_block(const Model& model, const Translator& tr)
{
    const std::optional<Block> block = block_of(model);
    if (!block) return {};
    return BlockCheck(model, *block, tr).run();
}

} // namespace femoop::cross
