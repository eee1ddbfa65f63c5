#include "femoop/io/cross/cross_json.h"

#include <algorithm>
#include <cmath>

#include "femoop/io/json/json_writer.h"
#include "femoop/methods/cross/fraction.h"
#include "femoop/methods/cross/rounding.h"
#include "femoop/methods/cross/symmetry.h"
#include "femoop/tabular/separated.h"

namespace femoop::cross {

namespace {

constexpr std::string_view step_names[] = {"FEM", "BAL", "CO", "TOTAL"};
constexpr std::string_view order_names[] = {"largest", "left-to-right", "all-at-once"};
constexpr double moment_round_off = 1e-12; // of the largest moment
constexpr int digits_of_a_sum = 14;        // adding rounded numbers leaves binary dust beyond

/// Numbers below round-off of the largest are 0, and sums of rounded numbers lose their dust.
std::vector<double> cleaned(std::vector<double> values, int digits)
{
    double largest = 0.0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    for (double& value : values) {
        if (std::abs(value) <= moment_round_off * largest) value = 0.0;
        if (digits > 0) value = rounded(value, digits_of_a_sum);
    }
    return values;
}

class SheetJson {
public:
    explicit SheetJson(const Worked& worked) : worked_(worked), problem_(worked.problem) {}

    std::string write()
    {
        json_.begin_object(JsonWriter::Layout::Block);
        write_procedure();
        write_factors(problem_.of_sheet(0));
        write_ends("fixed_end_moments", worked_.all.held.sheet.start.moments);
        if (problem_.sways.empty()) write_sheet(0, problem_.loading, worked_.all.held.sheet);
        else write_stages();
        write_ends("total", worked_.all.moments);
        write_ends("final", worked_.comparison.stiffness);
        write_ends("limit", worked_.comparison.limit);
        write_ends("inextensible", worked_.comparison.inextensible);
        write_joints("difference", worked_.comparison.difference);
        json_.end();
        return json_.take();
    }

private:
    const std::string& name(JointId joint) const { return worked_.model[problem_[joint].node].id; }

    void write_procedure()
    {
        const Procedure& procedure = worked_.procedure;
        json_.member("case", worked_.model.case_name(problem_.load_case)).key("order");
        if (procedure.order == Order::Listed) {
            json_.begin_array();
            for (const JointId joint : procedure.joints) json_.value(name(joint));
            json_.end();
        } else json_.value(order_names[static_cast<std::size_t>(procedure.order)]);
        json_.member("balances", worked_.all.held.sheet.steps.size());
        json_.member("tolerance", worked_.all.held.sheet.tolerance);
        json_.member("modified_stiffness", problem_.far_ends != FarEnds::Plain);
        if (procedure.digits > 0) json_.member("digits", procedure.digits);
        if (!problem_.halves.empty()) json_.member("symmetry", true);
    }

    /// Of every joint that is balanced, and of hinged ends.
    void write_factors(const Problem& half)
    {
        const std::vector<double> factors = factors_of(half, worked_.procedure.digits);
        json_.key("factors").begin_object();
        by_joint(half, [&](EndId e) { json_.member(half[e].label, factors[e.index]); });
        json_.end().key("fractions").begin_object();
        by_joint(half, [&](EndId e) {
            if (const auto fraction = fraction_of(half[e].factor))
                json_.member(half[e].label, fraction_text(*fraction));
        });
        json_.end();
    }

    static bool has_factor(const Problem& half, EndId e)
    {
        if (!half.is_on_sheet(e)) return false;
        return half[e].is_hinged || (half[e].joint && half.is_balanced(*half[e].joint));
    }

    template <class Write> void by_joint(const Problem& half, Write write)
    {
        for (std::size_t e = 0; e < problem_.ends.size();) {
            const NodeId node = problem_.ends[e].node;
            std::size_t past = e;
            bool is_free = false;
            while (past < problem_.ends.size() && problem_.ends[past].node == node) {
                is_free = is_free || has_factor(half, EndId(past));
                ++past;
            }
            if (is_free) json_.key(worked_.model[node].id).begin_object();
            for (; e < past; ++e)
                if (is_free && half.is_on_sheet(EndId(e))) write(EndId(e));
            if (is_free) json_.end();
        }
    }

    void write_values(const Problem& half, const std::vector<double>& values)
    {
        for (std::size_t e = 0; e < values.size(); ++e)
            if (half.is_on_sheet(EndId(e))) json_.member(problem_.ends[e].label, values[e]);
    }

    void write_ends(std::string_view key, const std::vector<double>& values)
    {
        json_.key(key).begin_object();
        write_values(problem_, cleaned(values, worked_.procedure.digits));
        json_.end();
    }

    void write_joints(std::string_view key, const std::vector<double>& values)
    {
        json_.key(key).begin_object();
        for (std::size_t j = 0; j < values.size(); ++j) json_.member(name(JointId(j)), values[j]);
        json_.end();
    }

    /// What half of the structure is balanced, and why its members have other stiffnesses.
    void write_half(const Problem& half)
    {
        const bool is_symmetric = half.mirror->kind == SymmetryKind::Symmetric;
        json_.key("half").begin_object(JsonWriter::Layout::Block);
        json_.member("kind", is_symmetric ? "symmetric" : "antisymmetric").member("axis", half.mirror->x);
        json_.key("joints").begin_array();
        for (const JointId joint : half.balanced_joints()) json_.value(name(joint));
        json_.end().key("crossing").begin_object();
        for (const EndId e : crossing_ends(half)) {
            json_.key(half[e].label).begin_object().member("stiffness", half[e].stiffness);
            if (const std::string_view text = formula(half, e); !text.empty()) json_.member("formula", text);
            json_.end();
        }
        json_.end();
        write_factors(half);
        json_.end();
    }

    void write_sheet(std::size_t stage, const Loading& loading, const Sheet& sheet)
    {
        const Problem& half = problem_.of_sheet(stage);
        if (half.mirror) write_half(half);
        json_.key("sheet").begin_array(JsonWriter::Layout::Block);
        for (const Row& row : rows_of(half, sheet)) {
            json_.begin_object().member("step", step_names[static_cast<std::size_t>(row.kind)]);
            if (row.joint) json_.member("joint", name(*row.joint));
            const bool is_sum = row.kind == RowKind::Total;
            write_values(half, is_sum ? cleaned(row.values, worked_.procedure.digits) : row.values);
            json_.end();
        }
        json_.end().key("convergence").begin_array();
        for (const double unbalance : convergence(sheet)) json_.value(unbalance);
        json_.end();
        if (const auto per_round = rate(half, sheet)) json_.member("rate", *per_round);
        if (worked_.procedure.digits > 0) write_ends("drift", drift(half, loading, sheet));
    }

    void write_stages()
    {
        json_.key("stages").begin_array(JsonWriter::Layout::Block);
        json_.begin_object(JsonWriter::Layout::Block);
        write_props();
        write_ends("fixed_end_moments", worked_.all.held.sheet.start.moments);
        write_sheet(0, problem_.loading, worked_.all.held.sheet);
        json_.end();
        for (std::size_t k = 0; k < problem_.sways.size(); ++k) write_sway(k);
        json_.end();
        write_equations();
    }

    void write_direction(const Sway& sway)
    {
        json_.member("node", worked_.model[sway.prop].id).key("direction").begin_array();
        json_.value(sway.direction[0]).value(sway.direction[1]).end();
    }

    void write_prop(std::size_t k, double reaction)
    {
        json_.begin_object();
        write_direction(problem_.sways[k]);
        json_.member("reaction", reaction).end();
    }

    void write_props()
    {
        const std::vector<double>& held = worked_.all.held.holding;
        if (held.size() == 1) {
            json_.key("prop");
            return write_prop(0, held[0]);
        }
        json_.key("props").begin_array();
        for (std::size_t k = 0; k < held.size(); ++k) write_prop(k, held[k]);
        json_.end();
    }

    void write_sway(std::size_t k)
    {
        const Sway& sway = problem_.sways[k];
        json_.begin_object(JsonWriter::Layout::Block).key("sway").begin_object();
        write_direction(sway);
        json_.member("displacement", sway.scale).key("chord_rotations").begin_object();
        for (std::size_t m = 0; m < sway.chord_rotation.size(); ++m)
            json_.member(worked_.model.members[m].id, sway.scale * sway.chord_rotation[m]);
        json_.end().end();
        write_ends("fixed_end_moments", sway.loading.fixed_end);
        write_sheet(k + 1, sway.loading, worked_.all.sways[k].sheet);
        json_.key("holding").begin_array();
        for (const double force : worked_.all.sways[k].holding) json_.value(force);
        json_.end().end();
    }

    void write_equations()
    {
        json_.key("equations").begin_object(JsonWriter::Layout::Block).key("coefficients").begin_array();
        for (Eigen::Index i = 0; i < worked_.all.R.rows(); ++i) {
            json_.begin_array();
            for (const double r : worked_.all.R.row(i)) json_.value(r);
            json_.end();
        }
        json_.end();
        for (const auto& [key, vector] : {std::pair{"right_hand_side", &worked_.all.r}, {"solution", &worked_.all.x}}) {
            json_.key(key).begin_array();
            for (const double value : *vector) json_.value(value);
            json_.end();
        }
        json_.end();
    }

    const Worked& worked_;
    const Problem& problem_;
    JsonWriter json_;
};

void add_rows(tabular::SeparatedText& csv, const Worked& worked, std::size_t stage, const Sheet& sheet)
{
    const Problem& half = worked.problem.of_sheet(stage);
    for (const Row& row : rows_of(half, sheet)) {
        csv << std::to_string(stage) << step_names[static_cast<std::size_t>(row.kind)];
        csv << (row.joint ? worked.model[worked.problem[*row.joint].node].id : std::string());
        const bool is_sum = row.kind == RowKind::Total;
        const std::vector<double> values = is_sum ? cleaned(row.values, worked.procedure.digits) : row.values;
        for (std::size_t e = 0; e < values.size(); ++e) {
            const bool is_written = is_sum || half.is_on_sheet(EndId(e));
            csv << (is_written ? tabular::Cell(values[e]) : tabular::Cell());
        }
        csv.end_row();
    }
}

} // namespace

std::string sheet_json(const Worked& worked) { return SheetJson(worked).write(); }

std::string sheet_csv(const Worked& worked)
{
    tabular::SeparatedText csv;
    csv << "stage"
        << "step"
        << "joint";
    for (const End& end : worked.problem.ends) csv << end.label;
    csv.end_row();
    add_rows(csv, worked, 0, worked.all.held.sheet);
    for (std::size_t k = 0; k < worked.all.sways.size(); ++k) add_rows(csv, worked, k + 1, worked.all.sways[k].sheet);
    return csv.take();
}

} // namespace femoop::cross
