#include <cstddef>
#include <string_view>

#include "femoop/io/derivation/derivation_text.h"
#include "femoop/io/force_method/force_method_text.h"
#include "femoop/io/influence/influence_json.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/methods/force_method/force_steps.h"

namespace femoop::force_method {

namespace {

using Layout = JsonWriter::Layout;

void write_vector(JsonWriter& json, std::string_view key, const Eigen::VectorXd& numbers)
{
    json.key(key).begin_array();
    for (const double one : numbers) json.value(one);
    json.end();
}

/// null: infinite.
void write_degree(JsonWriter& json, const Indeterminacy& degree)
{
    if (degree.has_foundation) json.null();
    else json.value(degree.total());
}

void write_redundants(JsonWriter& json, const ForceMethod& method, const Model& model)
{
    json.key("redundants").begin_array(Layout::Block);
    for (std::size_t i = 0; i < method.n_redundants(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        json.begin_object();
        influence::write_effect(json, model, method.redundants[i]);
        json.member("imposed", method.imposed[row]).member("flexibility", method.primary.releases[i].flexibility);
        json.member("value", method.X[row]).member("analysis", method.analysed[row]).end();
    }
    json.end();
}

} // namespace

std::string force_method_json(const ForceMethod& method, const Model& model, const Translator& tr)
{
    JsonWriter json;
    begin_output(json, model.units);
    json.key("force_method").begin_object(Layout::Block).member("case", model.case_name(method.load_case));
    write_degree(json.key("degree"), method.degree);
    write_degree(json.key("degree_of_primary"), method.states.indeterminacy());
    write_redundants(json, method, model);
    write_rows(json.key("delta"), method.delta);
    write_vector(json, "delta_0", method.delta_0);
    write_steps(json, steps(method, model), model, tr);
    json.end().end();
    return json.take();
}

} // namespace femoop::force_method
