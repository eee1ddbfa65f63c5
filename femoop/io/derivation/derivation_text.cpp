#include "femoop/io/derivation/derivation_text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "femoop/io/results/solver_trace_text.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/tabular/plain_text.h"

namespace femoop::derivation {

namespace {

constexpr std::array words{translatable("data"),       translatable("entries"), translatable("place"),
                           translatable("factors"),    translatable("factor"),  translatable("value"),
                           translatable("extremes"),   translatable("max"),     translatable("min"),
                           translatable("foundation"), translatable("spring"),  translatable("p at the node"),
                           translatable("sum"),        translatable("number"),  translatable("given"),
                           translatable("solver's"),   translatable("profile"), translatable("half bandwidth"),
                           translatable("supports"),   translatable("ground"),  translatable("entries of L"),
                           translatable("envelope"),   translatable("now"),     translatable("-kept")};

constexpr std::size_t indent = 2;
constexpr double trusted = 1e-6; // of the numbers that a sum is made of

bool has_empty_row(const Step& step)
{
    const Eigen::MatrixXd& K = step.matrices.front().values;
    for (Eigen::Index i = 0; i < K.rows(); ++i)
        if (K.row(i).isZero(0.0)) return true;
    return false;
}

std::string equations_sentence(const Step& step, const Translator& tr)
{
    std::string text = step.is_whole
                           ? tr("All equations K u = f, and the displacements u that solve them.")
                           : tr("Of the equations K u = f the rows that matter here, with all displacements in them; u "
                                "solves all of them at once.");
    if (has_empty_row(step)) text += " " + tr("A row of zeros: nothing resists that rotation, and it is taken as 0.");
    return text;
}

std::vector<std::string> symbol_texts(const std::vector<std::string>& symbols, const Translator& tr)
{
    std::vector<std::string> texts;
    for (const std::string& symbol : symbols) texts.push_back(symbol_text(symbol, tr));
    return texts;
}

std::string reduced_sentence(const Step& step, const Translator& tr)
{
    std::string text =
        step.is_whole ? tr("The equations that are left, G^T K G y = G^T (f - K u0), and the displacements y that "
                           "solve them; the others follow: u = G y + u0.")
                      : tr("Of the equations that are left, G^T K G y = G^T (f - K u0), the rows that matter here; "
                           "y solves all of them at once, and the other displacements follow: u = G y + u0.");
    if (has_empty_row(step)) text += " " + tr("A row of zeros: nothing resists that rotation, and it is taken as 0.");
    return text;
}

/// What changes from the numbering on paper to that of the solver.
std::string numbering_sentence(const Step& step, const Translator& tr)
{
    const Renumbering& order = *step.renumbering;
    const std::vector<std::string> sizes{std::to_string(order.given.half_bandwidth),
                                         std::to_string(order.solved.half_bandwidth),
                                         std::to_string(order.given.factor), std::to_string(order.solved.factor)};
    std::string text =
        fill(tr("The equations are numbered as given, node after node; the solver ({0}) eliminates in {1} "
                "order."),
             {std::string(name(order.solver)), ordering_text(order.ordering, tr)}) +
        " ";
    if (order.is_same_order())
        text += fill(tr("Here that is the same order: half bandwidth {0} before and after."), sizes);
    else if (order.is_no_gain())
        text += fill(tr("In a system so small that gains nothing: half bandwidth {0} before and after."), sizes);
    else
        text += fill(tr("Half bandwidth {0} before, {1} after; entries of the factor L {2} before, {3} after."), sizes);
    return text + " " + tr("The half bandwidth counts the longest row of K from its first entry to the diagonal.");
}

std::string reaction_sentence(const Step& step, const std::string& node, const Translator& tr)
{
    const std::string text = fill(
        tr("The support of node {0} brings what the members need there, less the load F on the node."), {node});
    const bool has_spring = step.matrices.size() > 1, is_free = !step.rows.empty() && !has_spring;
    if (has_spring) return text + " " + tr("Its spring k says the same of the displacement u.");
    return is_free ? text + " " + tr("It leaves this direction free: members and load balance there by themselves.")
                   : text;
}

bool is_tied(const Step& step, const Model& model)
{
    return step.member && (model[*step.member].inextensible || model[*step.member].rigid);
}

/// "A.rz', B.rz'" of the joints k(A.rz') among the data: those that are released, or those that are springs.
std::string joint_list(const Step& step, bool is_released)
{
    std::string list;
    const NamedMatrix& data = step.matrices.front();
    for (std::size_t i = 0; i < data.rows.size(); ++i) {
        const std::string& row = data.rows[i];
        const bool is_one = row.starts_with("k(") &&
                            (data.values(static_cast<Eigen::Index>(i), 0) == 0.0) == is_released;
        if (is_one) list += (list.empty() ? "" : ", ") + row.substr(2, row.size() - 3);
    }
    return list;
}

std::string member_sentence(const Step& step, const Member& member, const Translator& tr)
{
    std::string text = fill(tr("Member {0}: its length, and what it resists with."), {member.id});
    const auto add = [&](const std::string& sentence) { text += " " + sentence; };
    if (member.rigid) add(tr("It is rigid: its ends are tied, and nothing of it strains."));
    else if (member.inextensible) add(tr("It is inextensible: along its axis its ends are tied."));
    if (member.bar) add(tr("It is a bar: it resists along its axis alone."));
    if (!member.depths.empty())
        add(tr("Its depth goes straight from h(0) to h(L): EI(x) = EI(0) (1 + a1 x + a2 x^2 + a3 x^3), and EA(x) goes "
               "straight from EA(0) to EA(L)."));
    if (member.foundation) add(tr("It lies on a foundation, k per length and displacement."));
    if (const std::string list = joint_list(step, true); !list.empty())
        add(fill(tr("Released at its ends, k = 0: {0}."), {list}));
    if (const std::string list = joint_list(step, false); !list.empty())
        add(fill(tr("Springs k join its ends to the nodes: {0}."), {list}));
    return text;
}

bool has_joints(const Member& member)
{
    return std::ranges::any_of(std::array{&member.start, &member.end},
                               [](const MemberEnd* end) { return !end->release.is_empty() || !end->springs.empty(); });
}

/// What the letters in the entries of k' mean.
std::string local_stiffness_sentence(const Step& step, const Model& model, const Translator& tr)
{
    const Member& member = model[*step.member];
    std::string text = fill(tr("Stiffness k' of member {0} in its own axes: column by column the forces on its ends "
                               "when one of them moves by 1."),
                            {member.id}) +
                       " ";
    text += is_tied(step, model) && has_joints(member)
                ? tr("Its ends count as rigid in k': what is released or on a spring there has an unknown of its own, "
                     "and the spring joins it to the node in k.")
                : tr("Releases and springs at its ends are worked in.");
    const std::vector<std::string>& rows = step.matrices.front().rows;
    if (step.matrices.size() < 2) return text; // k' alone, with no entries before it
    const auto has = [&](std::string_view part) {
        return std::ranges::any_of(rows, [&](const std::string& row) { return row.find(part) != std::string::npos; });
    };
    const auto begins = [&](std::string_view part) {
        return std::ranges::any_of(rows, [&](const std::string& row) { return row.starts_with(part); });
    };
    const auto add = [&](const std::string& sentence) { text += " " + sentence; };
    if (begins("r1")) add(tr("r1 and r2 are the fixity factors of its ends: 1 where an end is rigid, 0 at a hinge."));
    if (has("∫"))
        add(tr("Along the taper the flexibilities are integrals over the length, and k' is their inverse: of the "
               "simple beam f1 and f2 are the rotations of its ends under a moment of 1 there, f12 that of one end "
               "under a moment of 1 at the other."));
    if (has("sinh")) add(tr("sin, cos, sinh and cosh are of β L, k is the foundation's, and D = sinh^2 − sin^2."));
    else if (begins("β"))
        add(tr("k is the foundation's. With shear strain or springs at the ends no short formula is usual: the member "
               "is put together from pieces in which its deflection is a power series."));
    if (begins("k L/3")) add(tr("k is the foundation's, all that a rigid member resists with."));
    return text;
}

/// One column bears its name, or the matrix'; more stand below that.
std::string matrix_text(const Step& step, const NamedMatrix& matrix, const Translator& tr)
{
    const bool is_column = matrix.columns.size() == 1;
    std::vector<std::string> columns = symbol_texts(matrix.columns, tr);
    const std::string symbol = symbol_text(matrix.symbol, tr);
    if (is_column && columns[0].empty()) columns[0] = symbol;
    const RowUnits units = row_units(notation_of(step, matrix));
    tabular::Table table = matrix_table(symbol_texts(matrix.rows, tr), columns, matrix.values, units);
    if (units == RowUnits::Different)
        for (tabular::Row& row : table.rows)
            row.cells[1] = tabular::Cell(*row.cells[1].number, six_digits(*row.cells[1].number, tr));
    else if (matrix.more_digits > 0) table = with_digits(std::move(table), written_digits(matrix), tr);
    return (is_column ? std::string() : symbol + "\n") + tabular::plain_text(table, {indent, decimal_mark(tr)});
}

} // namespace

int written_digits(const NamedMatrix& matrix, int usual) { return std::min(usual + matrix.more_digits, 12); }

Notation notation_of(const Step& step, const NamedMatrix& matrix)
{
    const bool is_last = &matrix == &step.matrices.back();
    switch (step.kind) {
    case StepKind::Member: return Notation::Mixed;
    case StepKind::LocalStiffness: return is_last ? Notation::Matrix : Notation::Mixed;
    case StepKind::Stiffness: return is_last ? Notation::List : Notation::Matrix;
    case StepKind::Combination: return is_last ? Notation::Sum : Notation::List;
    case StepKind::Reaction: return is_last ? Notation::Sum : Notation::Mixed;
    case StepKind::StiffnessRow:
    case StepKind::LoadRow:
    case StepKind::Superposition:
    case StepKind::TiedDisplacement:
    case StepKind::TurnedSupport:
    case StepKind::Difference:
    case StepKind::Flexibility: return Notation::Sum;
    case StepKind::Governing:
    case StepKind::Extreme:
    case StepKind::Resultant:
    case StepKind::Numbering:
    case StepKind::RightHandSide:
    case StepKind::TieForces:
    case StepKind::EndForces:
    case StepKind::NodeForces:
    case StepKind::Redundants:
    case StepKind::State:
    case StepKind::StateSuperposition: return Notation::List;
    default: return Notation::Matrix;
    }
}

RowUnits row_units(Notation notation) { return notation == Notation::Mixed ? RowUnits::Different : RowUnits::Alike; }

bool is_system(const Step& step)
{
    return step.kind == StepKind::Equations || step.kind == StepKind::ReducedEquations ||
           step.kind == StepKind::RedundantEquations;
}

bool is_lit(const Step& step, const NamedMatrix& matrix, std::size_t row, std::size_t column)
{
    if (step.kind == StepKind::Stiffness && notation_of(step, matrix) == Notation::Matrix) {
        const Eigen::VectorXd places = step.matrices.back().values.col(0);
        return places[static_cast<Eigen::Index>(row)] > 0.0 && places[static_cast<Eigen::Index>(column)] > 0.0;
    }
    if (step.kind != StepKind::Equations || !step.is_whole) return false;
    const auto is_meant = [&](std::size_t i) {
        return std::ranges::find(step.rows, static_cast<Eigen::Index>(i)) != step.rows.end();
    };
    return is_meant(row) && (matrix.columns.size() == 1 || !step.member || is_meant(column));
}

std::string symbol_text(const std::string& symbol, const Translator& tr)
{
    if (std::ranges::find(words, symbol) != words.end()) return tr(symbol);
    std::string text = symbol; // M(BC, 2,25): what stands behind the comma is a number
    const std::size_t place = text.rfind(", ");
    const std::size_t point = place == std::string::npos ? place : text.find('.', place);
    if (point != std::string::npos) text[point] = decimal_mark(tr);
    return text;
}

std::string with_raised_powers(std::string text)
{
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> powers{
        {{"^2", "²"}, {"^3", "³"}, {"^T", "ᵀ"}}};
    for (const auto& [written, raised] : powers)
        for (std::size_t at = text.find(written); at != std::string::npos; at = text.find(written, at + raised.size()))
            text.replace(at, written.size(), raised);
    return text;
}

std::string closing_text(const Derivation& derivation, const Translator& tr)
{
    if (derivation.closing_error == 0.0) return {};
    const std::vector<Step>& steps = derivation.steps;
    const bool has_forces_before = steps.size() > 1 && steps.back().kind == StepKind::Reaction; // on whole members
    double size = steps.back().matrices.back().values.cwiseAbs().maxCoeff();
    if (has_forces_before) size = std::max(size, steps[steps.size() - 2].matrices.front().values.cwiseAbs().maxCoeff());
    if (derivation.closing_error <= trusted * size) return {};
    return "\n" +
           fill(tr("The last sum is off by {0}: these numbers have 16 digits, and cancel. The analysis carries more of "
                   "them, and {1} holds."),
                {six_digits(derivation.closing_error, tr), six_digits(derivation.value, tr)}) +
           "\n";
}

namespace {

/// "S0 + X1 S1 + X2 S2", of many redundants "S0 + X1 S1 + .. + X9 S9".
std::string sum_of_states(std::size_t n_redundants)
{
    constexpr std::size_t most_written = 3;
    std::string sum = "S0";
    const auto add = [&](std::size_t i) { sum += " + X" + std::to_string(i) + " S" + std::to_string(i); };
    const bool is_short = n_redundants > most_written;
    for (std::size_t i = 1; i <= (is_short ? 1 : n_redundants); ++i) add(i);
    if (is_short) sum += " + ..";
    if (is_short) add(n_redundants);
    return sum;
}

std::string difference_sentence(const Step& step, const Model& model, const Translator& tr)
{
    if (step.load_case) return fill(tr("What is now, less what was kept: {0}."), {model.case_name(*step.load_case)});
    return tr("What is now, less what was kept. That is of another state of the model, or of another model, and has "
              "steps of its own.");
}

std::string redundants_sentence(const Step& step, const Translator& tr)
{
    const std::string given = tr(
        "c: what a released support is displaced by, 1/k: a spring that the force goes through.");
    if (step.matrices.size() == 1)
        return tr("Members stand on a continuous foundation, so that the degree of static indeterminacy is infinite. "
                  "These forces X are released; what the foundation adds is left in the primary structure.") +
               " " + given;
    const Eigen::MatrixXd& degrees = step.matrices.back().values; // n of the structure, n0 of the primary structure
    const auto degree = [&](Eigen::Index i) { return std::to_string(std::lround(degrees(i, 0))); };
    if (degrees(1, 0) == 0.0)
        return fill(tr("The structure is statically indeterminate to the degree n = {0}. These forces X are released; "
                       "the primary structure that is left is statically determinate (n0 = 0)."),
                    {degree(0)}) +
               " " + given;
    return fill(tr("The structure is statically indeterminate to the degree n = {0}. These forces X are released; the "
                   "primary structure that is left is still so, to the degree n0 = {1}."),
                {degree(0), degree(1)}) +
           " " + given;
}

} // namespace

std::string sentence(const Step& step, const Model& model, const Translator& tr)
{
    const std::string member = step.member ? model[*step.member].id : std::string();
    const std::string node = step.node ? model[*step.node].id : std::string();
    switch (step.kind) {
    case StepKind::Governing:
        return fill(
            tr("Of the envelope the largest value here is that of {0}, the smallest that of {1}; the greater in "
               "magnitude is followed: {2}."),
            {step.matrices[0].rows[0], step.matrices[0].rows[1], model.case_name(*step.load_case)});
    case StepKind::Combination: return tr("The combination adds up its load cases, each times its factor.");
    case StepKind::Extreme:
        return fill(tr("Along member {0} the value is largest and smallest here. The greater of both in magnitude is "
                       "followed."),
                    {member});
    case StepKind::Member: return member_sentence(step, model[*step.member], tr);
    case StepKind::LocalStiffness: return local_stiffness_sentence(step, model, tr);
    case StepKind::Transformation:
        return tr("T turns displacements of the nodes into the member's own axes: u' = T u.");
    case StepKind::Stiffness:
        return tr("In the axes of the nodes k = T^T k' T. Each row has its place in K; 0 where a support holds it.");
    case StepKind::FixedEndForces:
        return fill(
            tr("Forces that hold the ends of member {0} still under its loads: f0' in its own axes, f0 in those "
               "of the nodes. They stand with a minus sign in f."),
            {member});
    case StepKind::StiffnessRow:
        return fill(tr("A row of K: what each member at node {0}, and a spring there, brings to it."), {node});
    case StepKind::LoadRow:
        return fill(
            tr("The same row of f: the load F on node {0}, less the fixed-end forces f0 of its members, less what "
               "displacements imposed by supports bring."),
            {node});
    case StepKind::Numbering: return numbering_sentence(step, tr);
    case StepKind::RightHandSide:
        return tr("The right-hand side f: loads F on the nodes, less the fixed-end forces f0 of all members, and what "
                  "displacements imposed by supports bring.");
    case StepKind::Ties:
        return tr("Inextensible and rigid members tie displacements to one another, C u = c: a row for each tie, its "
                  "member beside it. Solved for as many displacements as there are ties, u = G y + u0 of those that "
                  "are left, y.");
    case StepKind::ImposedTies:
        return tr("What settlements and heat impose through the ties: c of C u = c, and with it u0 of u = G y + u0.");
    case StepKind::ReducedEquations: return reduced_sentence(step, tr);
    case StepKind::TiedDisplacement:
        return tr("This displacement follows others, by its row of u = G y + u0: each that it follows, times its "
                  "factor.");
    case StepKind::TieForces:
        return tr("What K u leaves of f: the ties carry it. It goes through the tied members, as if their stiffness "
                  "were as much larger than all others as one likes.");
    case StepKind::Equations: return equations_sentence(step, tr);
    case StepKind::EndDisplacements:
        return fill(tr("The nodes of member {0} move by u, and its ends, in its own axes, by u' = T u."), {member});
    case StepKind::EndForces:
        return fill(is_tied(step, model)
                        ? tr("Forces on the ends of member {0}: p' = k' u' + f0' + c', where c' is what "
                             "ties its ends.")
                        : tr("Forces on the ends of member {0}: p' = k' u' + f0'."),
                    {member});
    case StepKind::NodeForces:
        return fill(
            is_tied(step, model)
                ? tr("Forces of the nodes on member {0}: p = k u + f0 + c, where c is what ties its ends; below, "
                     "what node {1} does, in global axes.")
                : tr("Forces of the nodes on member {0}: p = k u + f0; below, what node {1} does, in global "
                     "axes."),
            {member, node});
    case StepKind::Superposition:
        if (is_tied(step, model))
            return tr(
                "There the motion of the ends, u', brings one part, the loads between held ends, f0', another, and "
                "the forces that tie the ends, c', the third.");
        return tr(
            "There the motion of the ends, u', brings one part, and the loads between held ends, f0', the other.");
    case StepKind::Reaction: return reaction_sentence(step, node, tr);
    case StepKind::TurnedSupport:
        return fill(tr("From the axes of the support of node {0}, which is turned, to the global ones."), {node});
    case StepKind::Resultant:
        return fill(tr("Both components of the reaction at node {0} are one force: R is the root of fx² + fy²."),
                    {node});
    case StepKind::Difference: return difference_sentence(step, model, tr);
    case StepKind::Redundants: return redundants_sentence(step, tr);
    case StepKind::State:
        if (step.state == 0)
            return tr("State 0: the loads alone on the primary structure. Section forces S0, reactions R0.");
        return fill(tr("State {0}: X{0} = 1 alone on the primary structure."), {std::to_string(step.state)});
    case StepKind::Flexibility:
        return fill(
            tr("By how much release {0} opens in every state: the work of the forces of state {0} on the strains of "
               "each state, part by part."),
            {std::to_string(step.state)});
    case StepKind::RedundantEquations: return tr("The redundants X close every release again: δ X = c - δ0.");
    case StepKind::StateSuperposition:
        return fill(
            tr("The states add up, each times its redundant: S = {0}. Below, the redundants beside those of the "
               "stiffness method."),
            {sum_of_states(step.matrices.back().rows.size())});
    case StepKind::Held: break;
    }
    return fill(tr("Node {0} is held in this direction: no unknown, but what its support imposes."), {node});
}

std::string number_name(const Derivation& derivation, const std::string& effect_name)
{
    const bool is_difference = !derivation.steps.empty() && derivation.steps.back().kind == StepKind::Difference;
    return is_difference ? "Δ" + effect_name : effect_name;
}

std::string derivation_title(const Derivation& derivation, const Model& model, const Translator& tr)
{
    if (!derivation.redundants.empty()) return fill(tr("Force method in {0}"), {model.case_name(derivation.load_case)});
    const std::string unit = printed_unit(influence::dimension_of(derivation.effect), model.units);
    return fill(tr("{0} = {1} in {2}: where it comes from"),
                {number_name(derivation, influence::effect_name(model, derivation.effect, tr)),
                 six_digits(derivation.value, tr) + " " + unit, model.case_name(derivation.load_case)});
}

std::string derivation_units(const Model& model, const Translator& tr)
{
    return fill(tr("Lengths in {0}, forces in {1}, rotations in rad."),
                {std::string(name(model.units.length)), std::string(name(model.units.force))});
}

std::string derivation_text(const Derivation& derivation, const Model& model, const Translator& tr)
{
    const std::string title = derivation_title(derivation, model, tr);
    std::string text = title + "\n" + std::string(tabular::shown_width(title), '=') + "\n";
    text += derivation_units(model, tr) + "\n";
    std::optional<CaseId> last;
    for (std::size_t i = 0; i < derivation.steps.size(); ++i) {
        const Step& step = derivation.steps[i];
        if (step.load_case && step.load_case != last)
            text += "\n" + fill(tr("Load case {0}"), {model.case_name(*step.load_case)}) + "\n";
        if (step.load_case) last = step.load_case;
        text += "\n" + std::to_string(i + 1) + ". " + sentence(step, model, tr) + "\n";
        for (const NamedMatrix& matrix : step.matrices) text += matrix_text(step, matrix, tr);
    }
    return text + closing_text(derivation, tr);
}

} // namespace femoop::derivation
