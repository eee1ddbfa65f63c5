#include <string_view>

#include "femoop/geometry/node_position.h"
#include "femoop/io/funicular/funicular_text.h"

namespace femoop::funicular {

namespace {

using Layout = JsonWriter::Layout;

void write_pair(JsonWriter& json, std::string_view key, double first, double second)
{
    json.key(key).begin_array().value(first).value(second).end();
}

void write_names(JsonWriter& json, std::string_view key, const std::vector<NodeId>& nodes, const Model& model)
{
    json.key(key).begin_array();
    for (const NodeId node : nodes) json.value(model[node].id);
    json.end();
}

void write_points(JsonWriter& json, std::string_view key, const std::vector<Eigen::Vector2d>& points)
{
    json.key(key).begin_array();
    for (const Eigen::Vector2d& point : points) json.begin_array().value(point.x()).value(point.y()).end();
    json.end();
}

void write_place(JsonWriter& json, const Funicular& funicular, const Chain& chain, NodeId node, double x,
                 const Model& model)
{
    const double e = funicular.height(x) - chain.height(x);
    json.begin_object().member("node", model[node].id).member("x", x).member("M0", funicular.span.moment(x));
    json.member("ordinate", funicular.ordinate(x)).member("height", funicular.height(x)).member("e", e);
    json.member("M", funicular.H * e).end();
}

std::string_view name_of(GivenRise::Place place)
{
    switch (place) {
    case GivenRise::Place::Hinge: return "hinge";
    case GivenRise::Place::Point: return "point";
    case GivenRise::Place::LargestMoment: break;
    }
    return "largest_M0";
}

void write_given_rise(JsonWriter& json, const GivenRise& rise)
{
    json.key("H_of").begin_object().member("place", name_of(rise.place)).member("x", rise.x);
    json.member("M0", rise.M0).member("f", rise.f).end();
}

void write_force_polygon(JsonWriter& json, const Funicular& funicular)
{
    const ForcePolygon polygon = force_polygon(funicular);
    json.key("force_polygon").begin_object(Layout::Block).key("loads").begin_array();
    for (const ForcePolygon::Load& load : polygon.loads)
        json.begin_object().member("x", load.x).member("P", load.P).end();
    json.end().key("levels").begin_array();
    for (const double level : polygon.levels) json.value(level);
    json.end();
    write_pair(json, "pole", polygon.pole.x(), polygon.pole.y());
    json.member("closing_level", polygon.closing_level);
    write_points(json, "corners", polygon.corners(funicular));
    json.end();
}

} // namespace

void write_funicular(JsonWriter& json, const Funicular& funicular, const Chain& chain, const Model& model)
{
    json.key("members").begin_array();
    for (const Chain::Link& link : chain.links) json.value(model[link.member].id);
    json.end();
    write_names(json, "left_out_at", chain.held, model);
    write_pair(json, "closing_line", funicular.closing_line.left, funicular.closing_line.right);
    json.member("H", funicular.H);
    write_given_rise(json, given_rise(funicular, chain));
    json.member("rise", funicular.rise());
    write_pair(json, "reactions", funicular.span.left_reaction(), funicular.span.right_reaction());
    const Extreme& most = funicular.span.largest_moment();
    json.key("largest_M0").begin_object().member("x", most.x).member("value", most.value).end();
    json.member("line_of_thrust", is_line_of_thrust(funicular, chain)).key("nodes").begin_array(Layout::Block);
    for (const NodeId node : chain.nodes)
        write_place(json, funicular, chain, node, position_of(model, node).x(), model);
    json.end();
    write_force_polygon(json, funicular);
}

} // namespace femoop::funicular
