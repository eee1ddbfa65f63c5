#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/io/plane/element_trace_output.h"

namespace femoop::plane {

namespace {

void write_list(JsonWriter& json, std::string_view key, const auto& values)
{
    json.key(key).begin_array();
    for (const auto& value : values) json.value(value);
    json.end();
}

} // namespace

std::string trace_json(const ElementTrace& trace, const Units& units)
{
    using Layout = JsonWriter::Layout;
    JsonWriter json;
    begin_output(json, units);
    json.key("trace").begin_object(Layout::Block).member("element", trace.element);
    json.member("kind", femoop::name(trace.kind)).member("formulation", name(trace.formulation));
    json.member("region", trace.region);
    write_list(json, "nodes", trace.nodes);
    write_list(json, "dofs", trace.dofs);
    write_list(json, "equations", trace.equations);
    write_rows(json.key("D"), trace.D, Layout::Block);
    json.key("points").begin_array(Layout::Block);
    for (const ElementTrace::Point& point : trace.points) {
        json.begin_object(Layout::Block);
        json.member("xi", point.natural.xi).member("eta", point.natural.eta).member("weight", point.weight);
        write_list(json, "at", point.at);
        write_list(json, "N", point.N);
        write_rows(json.key("J"), point.J, Layout::Block);
        json.member("det_J", point.area).member("depth", point.depth);
        write_rows(json.key("B"), point.B, Layout::Block);
        json.end();
    }
    json.end();
    write_rows(json.key("stiffness"), trace.stiffness, Layout::Block);
    if (trace.to_nodes.size() > 0) write_rows(json.key("stiffness_in_node_axes"), trace.to_nodes, Layout::Block);
    json.key("loads").begin_object(Layout::Block);
    for (const ElementTrace::NodalForces& load : trace.loads) write_list(json, load.load_case, load.f);
    json.end().end().end();
    return json.take();
}

} // namespace femoop::plane
