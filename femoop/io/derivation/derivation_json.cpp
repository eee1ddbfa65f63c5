#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "femoop/io/derivation/derivation_text.h"
#include "femoop/io/influence/influence_json.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"

namespace femoop::derivation {

namespace {

using Layout = JsonWriter::Layout;

constexpr std::array<std::string_view, n_step_kinds> step_names{
    // of a structure with members that stretch
    "governing", "combination", "extreme", "member", "local_stiffness", "transformation", "stiffness", "fixed_end",
    "stiffness_row", "load_row", "equations", "end_displacements", "end_forces", "node_forces", "superposition",
    "reaction", "turned_support", "held", "numbering", "right_hand_side", "resultant", "difference",
    // of ties
    "ties", "imposed_ties", "reduced_equations", "tied_displacement", "tie_forces",
    // of the force method
    "redundants", "state", "flexibility", "redundant_equations", "state_superposition"};

void write_names(JsonWriter& json, std::string_view key, const std::vector<std::string>& names)
{
    json.key(key).begin_array();
    for (const std::string& name : names) json.value(name);
    json.end();
}

void write_matrix(JsonWriter& json, const NamedMatrix& matrix)
{
    json.begin_object().member("symbol", matrix.symbol);
    write_names(json, "rows", matrix.rows);
    write_names(json, "columns", matrix.columns);
    write_rows(json.key("values"), matrix.values);
    json.end();
}

void write_step(JsonWriter& json, const Step& step, const Model& model, const Translator& tr)
{
    json.begin_object(Layout::Block).member("step", step_names.at(static_cast<std::size_t>(step.kind)));
    if (step.member) json.member("member", model[*step.member].id);
    if (step.node) json.member("node", model[*step.node].id);
    if (step.load_case) json.member("case", model.case_name(*step.load_case));
    if (step.kind == StepKind::State || step.kind == StepKind::Flexibility) json.member("state", step.state);
    if (step.renumbering) {
        json.member("solver", name(step.renumbering->solver));
        json.member("ordering", name(step.renumbering->ordering));
    }
    json.member("sentence", sentence(step, model, tr)).key("matrices").begin_array(Layout::Block);
    for (const NamedMatrix& matrix : step.matrices) write_matrix(json, matrix);
    json.end().end();
}

} // namespace

void write_steps(JsonWriter& json, const Derivation& derivation, const Model& model, const Translator& tr)
{
    json.key("steps").begin_array(Layout::Block);
    for (const Step& step : derivation.steps) write_step(json, step, model, tr);
    json.end();
}

void write_why(JsonWriter& json, const Derivation& derivation, const Model& model, const Translator& tr)
{
    json.key("why").begin_object(Layout::Block);
    influence::write_effect(json, model, derivation.effect);
    json.member("case", model.case_name(derivation.load_case)).member("value", derivation.value);
    json.member("closing_error", derivation.closing_error);
    write_steps(json, derivation, model, tr);
    json.end();
}

std::string derivation_json(const Derivation& derivation, const Model& model, const Translator& tr)
{
    JsonWriter json;
    begin_output(json, model.units);
    write_why(json, derivation, model, tr);
    json.end();
    return json.take();
}

} // namespace femoop::derivation
