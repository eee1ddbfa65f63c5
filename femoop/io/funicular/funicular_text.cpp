#include "femoop/io/funicular/funicular_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "femoop/geometry/node_position.h"
#include "femoop/io/results/matrix_table.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/tabular/latex.h"
#include "femoop/tabular/plain_text.h"

namespace femoop::funicular {

namespace {

constexpr std::size_t indent = 2;
constexpr double negligible = 1e-9; // of the span, of the largest moment

/// Numbers with the units of the model, what is rounding beside `size` as 0.
class Printer {
public:
    Printer(const Model& model, const Translator& tr) : model_(model), tr_(tr) {}

    std::string number(double value, double size) const
    {
        if (std::abs(value) <= negligible * size) return "0";
        return (value < 0.0 ? "−" : "") + six_digits(std::abs(value), tr_);
    }
    std::string factor(double value, double size) const ///< behind a sign of multiplication or division
    {
        const std::string text = number(value, size);
        return text.starts_with("−") ? "(" + text + ")" : text;
    }
    std::string operator()(double value, Dimension dimension, double size) const
    {
        return number(value, size) + " " + unit(dimension);
    }
    std::string unit(Dimension dimension) const { return printed_unit(dimension, model_.units); }

private:
    const Model& model_;
    const Translator& tr_;
};

std::string chain_text(const Chain& chain, const Model& model, const Translator& tr)
{
    std::vector<std::string> names;
    for (const Chain::Link& link : chain.links) names.push_back(model[link.member].id);
    return fill(tr("Funicular over {0} from {1} to {2}"),
                {listed(names), model[chain.nodes.front()].id, model[chain.nodes.back()].id}, tr(translatable("and")));
}

std::string thrust_pattern(GivenRise::Place place, bool is_thrust, const Translator& tr)
{
    switch (place) {
    case GivenRise::Place::Hinge:
        return is_thrust ? tr("thrust H = M0 / f = {0} / {1} = {2}, M0 and f at the hinge, x = {3}")
                         : tr("pull: H = M0 / f = {0} / {1} = {2}, M0 and f at the hinge, x = {3}");
    case GivenRise::Place::Point:
        return is_thrust ? tr("thrust H = M0 / f = {0} / {1} = {2}, M0 and f at the point it is led through, x = {3}")
                         : tr("pull: H = M0 / f = {0} / {1} = {2}, M0 and f at the point it is led through, x = {3}");
    case GivenRise::Place::LargestMoment: break;
    }
    return is_thrust ? tr("thrust H = M0 / f = {0} / {1} = {2}, M0 largest at x = {3}")
                     : tr("pull: H = M0 / f = {0} / {1} = {2}, M0 largest at x = {3}");
}

std::string thrust_line(const Funicular& funicular, const Chain& chain, const Model& model, const Translator& tr)
{
    const Printer text(model, tr);
    const GivenRise rise = given_rise(funicular, chain);
    return fill(thrust_pattern(rise.place, funicular.H > 0.0, tr),
                {text.number(rise.M0, 0.0), text.factor(rise.f, 0.0), text(funicular.H, dimension::force, 0.0),
                 text(rise.x, dimension::length, funicular.span.length())});
}

std::string reactions_line(const Funicular& funicular, const Chain& chain, const Model& model, const Translator& tr)
{
    const Printer text(model, tr);
    const double left = funicular.span.left_reaction(), right = funicular.span.right_reaction();
    const double size = std::abs(left) + std::abs(right);
    return fill(tr("reactions of the simple beam: {0} at {1}, {2} at {3}"),
                {text(left, dimension::force, size), model[chain.nodes.front()].id, text(right, dimension::force, size),
                 model[chain.nodes.back()].id});
}

std::string left_out_line(const Chain& chain, const Model& model, const Translator& tr)
{
    constexpr std::size_t most_named = 6;
    if (chain.held.size() > most_named)
        return fill(tr("left out: what supports and other members do at {0} nodes between the ends"),
                    {std::to_string(chain.held.size())});
    std::vector<std::string> names;
    for (const NodeId node : chain.held) names.push_back(model[node].id);
    return femoop::fill(tr("left out: what supports and other members do at {0} between the ends"), {listed(names)},
                        tr(translatable("and")));
}

std::vector<std::string> names_on_foundation(const Chain& chain, const Model& model)
{
    std::vector<std::string> names;
    for (const Chain::Link& link : chain.links)
        if (model[link.member].foundation) names.push_back(model[link.member].id);
    return names;
}

std::string foundation_line(const std::vector<std::string>& names, const Translator& tr)
{
    return femoop::fill(tr("left out: the elastic foundation under {0}; with it the beam's reactions and M are others"),
                        {listed(names)}, tr(translatable("and")));
}

tabular::Table table(const Funicular& funicular, const Chain& chain, const Model& model, const Translator& tr)
{
    const Printer text(model, tr);
    const std::string length = text.unit(dimension::length), moment = text.unit(dimension::moment);
    tabular::Table table(std::vector<tabular::Column>{tabular::Column(tr("node")),
                                                      {"x", length},
                                                      {"M0", moment},
                                                      {"η = M0 / H", length},
                                                      {"e", length},
                                                      {"H e", moment}});
    for (const NodeId node : chain.nodes) {
        const Eigen::Vector3d place = position_of(model, node);
        const double e = funicular.height(place.x()) - place.y();
        const double shown_e = std::abs(e) <= negligible * chain.span() ? 0.0 : e;
        table.add_row({model[node].id, place.x(), funicular.span.moment(place.x()), funicular.ordinate(place.x()),
                       shown_e, funicular.H * shown_e});
    }
    table.silence_round_off({2});
    table.silence_round_off({3});
    return table;
}

std::string pole_line(const ForcePolygon& polygon, const Model& model, const Translator& tr)
{
    const Printer text(model, tr);
    const double size = std::abs(polygon.levels.back());
    const auto level = [&](double value) { return text(value, dimension::force, size); };
    const std::string pattern =
        polygon.pole.x() < 0.0
            ? tr("force polygon: load line from 0 to {0}; pole O at height {1}, {2} to its left; the ray parallel to the "
                 "closing line ends at {3}")
            : tr("force polygon: load line from 0 to {0}; pole O at height {1}, {2} to its right; the ray parallel to "
                 "the closing line ends at {3}");
    return fill(pattern, {level(polygon.levels.back()), level(polygon.pole.y()), level(std::abs(polygon.pole.x())),
                          level(polygon.closing_level)});
}

/// Corners of the funicular polygon, each with its load and the ray that the side behind it is parallel to.
tabular::Table polygon_table(const Funicular& funicular, const ForcePolygon& polygon, const Model& model,
                             const Translator& tr)
{
    const Printer text(model, tr);
    const std::string length = text.unit(dimension::length), force = text.unit(dimension::force);
    tabular::Table table({{tr("corner"), "", tabular::Alignment::Left},
                          {"x", length},
                          {"y", length},
                          {"P", force},
                          {tr("ray to"), force}});
    const std::vector<Eigen::Vector2d> corners = polygon.corners(funicular);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const bool has_load = i > 0 && i <= polygon.loads.size(), has_side = i < polygon.levels.size();
        table.add_row({std::to_string(i), corners[i].x(), corners[i].y(),
                       has_load ? tabular::Cell(polygon.loads[i - 1].P) : tabular::Cell(),
                       has_side ? tabular::Cell(polygon.levels[i]) : tabular::Cell()});
    }
    table.silence_round_off({1, 2});
    table.silence_round_off({4});
    return table;
}

} // namespace

std::string sentence(const Refusal& refusal, const Model& model, const Translator& tr)
{
    const auto member = [&](std::size_t i) { return model[refusal.members.at(i)].id; };
    const auto place = [&] {
        return refusal.nodes.empty() ? fill(tr("member {0}"), {member(0)})
                                     : fill(tr("node {0}"), {model[refusal.nodes.front()].id});
    };
    const Printer text(model, tr);
    const auto amount = [&](Dimension of) {
        return text(refusal.value, of, 0.0) +
               (refusal.is_distributed ? "/" + text.unit(dimension::length) : std::string());
    };
    switch (refusal.kind) {
    case RefusalKind::NotPlaneFrame:
        return fill(tr("a funicular is drawn in a plane frame, and this is a {0}; make the model a frame2d"),
                    {std::string(name(model.analysis))});
    case RefusalKind::NoMember:
        return tr("no member runs from left to right; draw an arch or a beam, or select the members of one");
    case RefusalKind::Upright:
        return fill(tr("member {0} stands upright, and a chain runs from left to right; select members without it"),
                    {member(0)});
    case RefusalKind::Fork:
        return fill(tr("members {0} and {1} go the same way from node {2}, so they are no chain; select the members of "
                       "one arch or beam"),
                    {member(0), member(1), model[refusal.nodes.front()].id});
    case RefusalKind::Apart:
        return fill(tr("no members lead from {0} to {1}, so they are no chain; select the members of one arch or beam"),
                    {member(0), member(1)});
    case RefusalKind::NoCase: return tr("the model has no load case, so there is nothing to carry; add a load");
    case RefusalKind::NotVertical:
        return fill(
            tr("the load on {0} has a horizontal part of {1}, and a funicular carries vertical loads alone; show "
               "another load case, or turn the load"),
            {place(), amount(dimension::force)});
    case RefusalKind::Couple:
        return fill(
            tr("the load on {0} is a moment of {1}, and a funicular carries vertical loads alone; show another load "
               "case, or take the moment away"),
            {place(), amount(dimension::moment)});
    case RefusalKind::NoLoad: break;
    }
    return tr("no vertical load acts between the ends of the chain; show another load case, or add a load");
}

std::vector<std::string> funicular_lines(const Funicular& funicular, const Chain& chain, const Model& model,
                                         const Translator& tr)
{
    std::vector<std::string> lines{thrust_line(funicular, chain, model, tr),
                                   reactions_line(funicular, chain, model, tr)};
    if (is_line_of_thrust(funicular, chain)) lines.front() += "; " + tr("the line of thrust of the arch");
    if (!chain.held.empty()) lines.push_back(left_out_line(chain, model, tr));
    if (const auto names = names_on_foundation(chain, model); !names.empty())
        lines.push_back(foundation_line(names, tr));
    return lines;
}

std::string reading_line(const Funicular& funicular, const Chain& chain, double x, const Model& model,
                         const Translator& tr)
{
    const Printer text(model, tr);
    const double most = std::abs(funicular.span.largest_moment().value), length = chain.span();
    const double M0 = funicular.span.moment(x), eta = funicular.ordinate(x), e = funicular.height(x) - chain.height(x);
    const std::string H = text.number(funicular.H, 0.0);
    return fill(tr("at x = {0}: M0 = H η = {1} · {2} = {3}; as line of thrust M = H e = {1} · {4} "
                   "= {5}"),
                {text(x, dimension::length, length), H, text.factor(eta, length), text(M0, dimension::moment, most),
                 text.factor(e, length),
                 text(funicular.H * e, dimension::moment, std::max(most, std::abs(funicular.H) * length))});
}

std::string funicular_text(const Funicular& funicular, const Chain& chain, const Model& model, const Translator& tr)
{
    const auto plain = [&](const tabular::Table& of) { return tabular::plain_text(of, {indent, decimal_mark(tr)}); };
    std::string text = chain_text(chain, model, tr) + "\n";
    for (const std::string& line : funicular_lines(funicular, chain, model, tr)) text += line + "\n";
    const ForcePolygon polygon = force_polygon(funicular);
    return text + "\n" + plain(table(funicular, chain, model, tr)) + "\n" + pole_line(polygon, model, tr) + "\n" +
           plain(polygon_table(funicular, polygon, model, tr)) + "\n";
}

std::string funicular_latex(const Funicular& funicular, const Chain& chain, const Model& model, const Translator& tr)
{
    std::string text = "\\section*{" + tabular::latex_text(chain_text(chain, model, tr)) + "}\n";
    const auto add = [&](const std::string& line) { text += "\\par\\noindent\n" + tabular::latex_text(line) + "\n"; };
    for (const std::string& line : funicular_lines(funicular, chain, model, tr)) add(line);
    text += latex_table(table(funicular, chain, model, tr), tr);
    const ForcePolygon polygon = force_polygon(funicular);
    add(pole_line(polygon, model, tr));
    return text + latex_table(polygon_table(funicular, polygon, model, tr), tr);
}

} // namespace femoop::funicular
