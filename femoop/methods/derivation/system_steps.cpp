#include "femoop/methods/derivation/system_steps.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "femoop/model/quantity/six_digits.h"

namespace femoop::derivation {

namespace {

using Rows = std::vector<Eigen::Index>;

/// The columns that have anything, with their names; the last one always.
NamedMatrix without_empty_columns(NamedMatrix matrix)
{
    Rows kept;
    std::vector<std::string> names;
    for (Eigen::Index j = 0; j < matrix.values.cols(); ++j)
        if (j + 1 == matrix.values.cols() || !matrix.values.col(j).isZero(0.0)) {
            kept.push_back(j);
            names.push_back(matrix.columns[static_cast<std::size_t>(j)]);
        }
    matrix.values = Eigen::MatrixXd(matrix.values(Eigen::all, kept));
    matrix.columns = names;
    return matrix;
}

} // namespace

SystemSteps::SystemSteps(const PaperSystem& system, Rows rows, Step about)
    : system_(system), rows_(std::move(rows)), about_(std::move(about))
{}

Step SystemSteps::step(StepKind kind, std::optional<CaseId> load_case, std::vector<NamedMatrix> matrices) const
{
    Step step = about_;
    step.kind = kind;
    step.load_case = load_case;
    step.matrices = std::move(matrices);
    step.rows = rows_;
    return step;
}

std::vector<Step> SystemSteps::order() const
{
    std::vector<Step> steps;
    if (system_.trace().ties && !tying_rows().empty()) steps.push_back(ties());
    if (!system_.trace().place.empty()) steps.push_back(numbering());
    return steps;
}

Rows SystemSteps::tying_rows() const
{
    const Eigen::MatrixXd& C = system_.trace().ties->C;
    Rows rows;
    for (Eigen::Index i = 0; i < C.rows(); ++i) {
        const Eigen::RowVectorXd here = C.row(i)(system_.written_rows(rows_));
        if (here.size() > 0 && !here.isZero(0.0)) rows.push_back(i);
    }
    return rows;
}

Step SystemSteps::ties() const
{
    const SystemTrace::Ties& ties = *system_.trace().ties;
    const Rows rows = tying_rows();
    Rows columns = system_.all_rows();
    std::erase_if(columns, [&](Eigen::Index j) { return ties.C.col(j)(rows).isZero(0.0); });
    std::vector<std::string> members;
    for (const Eigen::Index row : rows)
        members.push_back(system_.model()[ties.members[static_cast<std::size_t>(row)]].id);
    const Rows unknowns = system_.written_rows(rows_), solved = system_.solved_rows(unknowns);
    const Eigen::MatrixXd G = ties.G;
    return step(StepKind::Ties, std::nullopt,
                {{"C", members, system_.names_of(columns), ties.C(rows, columns)},
                 {"G", system_.names_of(unknowns), system_.solved_names(solved), G(unknowns, solved)}});
}

Step SystemSteps::numbering() const
{
    const Renumbering order = renumbering_of(system_.trace());
    Rows solved = system_.solved_rows(rows_);
    if (system_.is_written_whole()) {
        solved.resize(order.place.size());
        std::iota(solved.begin(), solved.end(), Eigen::Index{0});
    }
    Eigen::MatrixXd places(static_cast<Eigen::Index>(solved.size()), 2);
    for (std::size_t i = 0; i < solved.size(); ++i)
        places.row(static_cast<Eigen::Index>(i)) << static_cast<double>(solved[i] + 1),
            order.place[static_cast<std::size_t>(solved[i])] + 1.0;
    Eigen::MatrixXd sizes(3, 2);
    const auto size = [](std::size_t n) { return static_cast<double>(n); };
    sizes << size(order.given.half_bandwidth), size(order.solved.half_bandwidth), size(order.given.profile),
        size(order.solved.profile), size(order.given.factor), size(order.solved.factor);
    Step step = this->step(StepKind::Numbering, std::nullopt,
                           {{"K", {"half bandwidth", "profile", "entries of L"}, {"given", "solver's"}, sizes},
                            {"number", system_.solved_names(solved), {"given", "solver's"}, places}});
    step.renumbering = order;
    return step;
}

Step SystemSteps::right_hand_side(CaseId load_case) const
{
    const SystemTrace& trace = system_.trace();
    const Rows rows = system_.written_rows(rows_);
    const auto c = static_cast<Eigen::Index>(load_case.index);
    Eigen::MatrixXd shares(trace.f.rows(), 4);
    shares << trace.f_of_nodes.col(c), trace.f_of_members.col(c), trace.f_of_supports.col(c), trace.f.col(c);
    return step(StepKind::RightHandSide, load_case,
                {without_empty_columns(
                    {"f", system_.names_of(rows), {"F", "-f0", "supports", "f"}, shares(rows, Eigen::all)})});
}

std::optional<Step> SystemSteps::imposed(CaseId load_case) const
{
    if (!system_.trace().ties) return std::nullopt;
    const SystemTrace::Ties& ties = *system_.trace().ties;
    const Rows rows = tying_rows(), unknowns = system_.written_rows(rows_);
    const auto c = static_cast<Eigen::Index>(load_case.index);
    const Eigen::VectorXd value = ties.c.col(c)(rows), u0 = ties.u0.col(c)(unknowns);
    if (value.isZero(0.0) && u0.isZero(0.0)) return std::nullopt;
    std::vector<std::string> members;
    for (const Eigen::Index row : rows)
        members.push_back(system_.model()[ties.members[static_cast<std::size_t>(row)]].id);
    return step(StepKind::ImposedTies, load_case,
                {{"c", members, {"c"}, value}, {"u0", system_.names_of(unknowns), {"u0"}, u0}});
}

Step SystemSteps::equations(CaseId load_case, const CaseResult& result) const
{
    const StepKind kind = system_.trace().ties ? StepKind::ReducedEquations : StepKind::Equations;
    Step step = this->step(kind, load_case, system_.equations(rows_, load_case, result));
    step.is_whole = system_.is_written_whole();
    return step;
}

std::vector<Step> SystemSteps::tie_forces(CaseId load_case, const CaseResult& result) const
{
    if (!system_.trace().ties || rows_.empty()) return {};
    const SystemTrace& trace = system_.trace();
    const Rows rows = system_.written_rows(rows_);
    const Eigen::VectorXd f = trace.f.col(static_cast<Eigen::Index>(load_case.index));
    const Eigen::VectorXd elastic = trace.K * system_.unknowns_in(result);
    Eigen::MatrixXd values(f.size(), 3);
    values << f, elastic, f - elastic;
    return {step(StepKind::TieForces, load_case,
                 {{"f - K u", system_.names_of(rows), {"f", "K u", "f - K u"}, values(rows, Eigen::all)}})};
}

std::vector<Step> SystemSteps::solved(CaseId load_case, const CaseResult& result) const
{
    std::vector<Step> steps;
    const bool has_unknowns = system_.trace().f.rows() > 0; // else supports hold all
    if (!rows_.empty() || (has_unknowns && system_.has_few_unknowns())) steps.push_back(right_hand_side(load_case));
    if (auto imposed = this->imposed(load_case)) steps.push_back(std::move(*imposed));
    if (!system_.trace().place.empty()) steps.push_back(equations(load_case, result));
    return steps;
}

std::optional<Step> SystemSteps::tied_displacement(Eigen::Index row, CaseId load_case, const CaseResult& result) const
{
    if (!system_.trace().ties) return std::nullopt;
    const SystemTrace::Ties& ties = *system_.trace().ties;
    if (std::ranges::binary_search(ties.independent, row)) return std::nullopt;
    const Eigen::VectorXd y = system_.unknowns_in(result)(ties.independent);
    const Rows followed = system_.solved_rows({row});
    const std::vector<std::string> names = system_.solved_names(followed);
    NamedMatrix sum{system_.name_of(row), {}, {""}, Eigen::MatrixXd(static_cast<Eigen::Index>(followed.size()) + 2, 1)};
    for (std::size_t i = 0; i < followed.size(); ++i) {
        const double factor = ties.G.coeff(row, followed[i]);
        sum.rows.push_back(six_digits(factor, english) + " " + names[i]);
        sum.values(static_cast<Eigen::Index>(i), 0) = factor * y[followed[i]];
    }
    sum.rows.emplace_back("u0");
    sum.rows.push_back(sum.symbol);
    const Eigen::Index n = sum.values.rows();
    sum.values(n - 2, 0) = ties.u0(row, static_cast<Eigen::Index>(load_case.index));
    sum.values(n - 1, 0) = sum.values.topRows(n - 1).sum();
    return step(StepKind::TiedDisplacement, load_case, {sum});
}

} // namespace femoop::derivation
