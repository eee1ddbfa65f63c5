#include "femoop/io/cross/cross_check.h"

#include <optional>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/cross/sheet_check.h"
#include "femoop/io/cross/stage_check.h"
#include "femoop/methods/cross/state_model.h"
#include "femoop/methods/cross/symmetry.h"

namespace femoop::cross {

namespace {

/// With its sways held where the file holds them.
Problem problem_as_in(const Block& block, const Model& model)
{
    const CaseId load_case = case_of(model, block);
    Problem problem = propped_as_in(block, model, problem_of(model, load_case, far_ends_of(model, load_case, block)));
    return block.is_by_halves ? by_halves(model, problem) : problem;
}

void check_factors(SheetCheck& check)
{
    const std::vector<double> factors = factors_of(check.problem().of_sheet(0), check.block().digits);
    for (const auto& [joint, wanted] : check.block().factors)
        check.row(fill(check.tr()("cross: factors of {0}"), {joint}), wanted, factors, check.of_sheet());
}

void check_sheet(SheetCheck& check)
{
    const std::vector<Block::Row>& wanted = check.block().sheet;
    if (wanted.empty()) return;
    const Problem& half = check.problem().of_sheet(0);
    check.sheet(wanted, half, check.worked(half, check.problem().loading, wanted),
                {"cross.sheet", check.tr()("cross")});
}

void check_final(SheetCheck& check)
{
    if (check.block().last.empty()) return;
    const Problem& problem = check.problem();
    const auto moments_of = [&](const Model& model) {
        return end_moments(model, problem, analyse(model)[problem.load_case]);
    };
    SheetCheck::Exact moments{.strained = moments_of(check.model()), .unstrained = {}};
    moments.unstrained = problem.sways.empty() ? moments.strained : moments_of(inextensible_copy(check.model()));
    for (const auto& wanted : check.block().last) check.row(check.tr()("cross: final"), {wanted}, moments);
}

} // namespace

std::vector<CheckOutcome> check_block(const Model& model, const Translator& tr)
{
    const std::optional<Block> block = block_of(model);
    if (!block) return {};
    const Problem problem = problem_as_in(*block, model);
    SheetCheck check(model, *block, problem, tr);
    check_factors(check);
    check.row(tr("cross: fixed-end moments"), block->fixed_end, problem.loading.fixed_end, check.of_sheet());
    check_sheet(check);
    check_stages(check);
    check_final(check);
    return check.take();
}

} // namespace femoop::cross
