#include "apps/cross/session/typed_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "apps/cross/session/edit.h"
#include "apps/cross/view/numbers.h"
#include "apps/cross/view/stiffness.h"
#include "apps/frame/document/fault/place.h"
#include "apps/frame/document/loading.h"
#include "femoop/edit/naming.h"
#include "femoop/model/check/check.h"
#include "ui/text/arithmetic.h"
#include "ui/text/number_format.h"

namespace cross {

using femoop::Model;
using ui::Measure;
using ui::Message;
using ui::translatable;

namespace {

constexpr int exact_digits = 15;
constexpr double usual_uniform = 10.0, usual_force = 20.0; // in the units shown

using Typed = std::variant<Model, Message>;

ui::DisplayUnits units_in(const Session& session) { return units_of(session.document().model, session.tr()); }

std::vector<double> levels(const Model& model, std::size_t axis)
{
    std::vector<double> found;
    for (const femoop::Node& node : model.nodes) found.push_back(node.at[axis].value());
    std::ranges::sort(found);
    const double near = found.empty() ? 0.0 : 1e-6 * (found.back() - found.front());
    const auto are_one = [near](double a, double b) { return b - a <= near; };
    found.erase(std::unique(found.begin(), found.end(), are_one), found.end());
    return found;
}

/// The nearest of several values that are written alike.
class Nearest {
public:
    explicit Nearest(ui::Point at) : at_(at) {}
    void consider(const TypedValue& value, double distance)
    {
        if (found && distance >= distance_) return;
        found = value;
        distance_ = distance;
    }
    ui::Point at() const { return at_; }
    std::optional<TypedValue> found;

private:
    ui::Point at_;
    double distance_ = 0.0;
};

/// A length that leaves its unit to the picture's title is known by its colour.
bool may_be_bare_length(const Session& session, const Drawn& drawn, const WrittenText& written)
{
    const ui::Color color = ui::Theme(session.look.theme).text(ui::Role::Dimension).color;
    return written.color == color && drawn.is_in_structure(written.box.center());
}

void consider_levels(Nearest& nearest, const Session& session, const Drawn& drawn, const WrittenText& written)
{
    const ui::DisplayUnits units = units_in(session);
    const bool is_bare = may_be_bare_length(session, drawn, written);
    const auto is_written = [&](double length) {
        return units.text(length, Measure::Length) == written.text ||
               (is_bare && units.number(length, Measure::Length) == written.text);
    };
    for (const int axis : {0, 1}) {
        const std::vector<double> all = levels(session.document().model, static_cast<std::size_t>(axis));
        for (std::size_t i = 0; i + 1 < all.size(); ++i) {
            if (!is_written(all[i + 1] - all[i])) continue;
            const double middle = 0.5 * (all[i] + all[i + 1]);
            const ui::Point at = drawn.on_sheet({axis == 0 ? middle : 0.0, axis == 0 ? 0.0 : middle});
            nearest.consider(Level{axis, all[i], all[i + 1]},
                             std::abs(axis == 0 ? at.x - nearest.at().x : at.y - nearest.at().y));
        }
    }
}

bool is_value(const frame::Number& number)
{
    constexpr std::array values{Measure::Force, Measure::Moment, Measure::ForcePerLength, Measure::MomentPerLength};
    return std::ranges::find(values, number.measure) != values.end() && number.value;
}

std::optional<TypedValue> largest_of(const Session& session, const frame::Part& load)
{
    std::optional<frame::Number> best;
    for (const frame::Number& number : frame::numbers(session.document().model, load)) {
        if (!is_value(number)) continue;
        if (!best || std::abs(*number.value) > std::abs(*best->value)) best = number;
    }
    return best ? std::optional<TypedValue>(best->id) : std::nullopt;
}

double distance_to(const drawing::LoadMark& mark, ui::Point at)
{
    double nearest = std::min(ui::distance(mark.root, at), ui::distance(mark.tip, at));
    for (std::size_t i = 0; i < mark.area.size(); ++i) {
        const ui::Point a = mark.area[i], b = mark.area[(i + 1) % mark.area.size()];
        const double length = std::max(1e-9, ui::distance(a, b));
        const double share = std::clamp(ui::dot(at - a, b - a) / (length * length), 0.0, 1.0);
        nearest = std::min(nearest, ui::distance(a + share * (b - a), at));
    }
    return nearest;
}

/// A value that leaves its unit to the picture's title is known by the mark around it.
void consider_loads(Nearest& nearest, const Session& session, const Drawn& drawn, const std::string& text)
{
    const ui::DisplayUnits units = units_in(session);
    for (const drawing::LoadMark& mark : drawn.loads)
        for (const frame::Number& number : frame::numbers(session.document().model, mark.load)) {
            if (!is_value(number)) continue;
            const double value = std::abs(*number.value);
            const bool is_bare = is_within(mark, nearest.at()) && units.number(value, number.measure) == text;
            if (is_bare || units.text(value, number.measure) == text)
                nearest.consider(number.id, distance_to(mark, nearest.at()));
        }
}

void consider_stiffnesses(Nearest& nearest, const Session& session, const Drawn& drawn, const std::string& text)
{
    if (!text.ends_with("EI")) return;
    const Model& model = session.document().model;
    for (std::size_t m = 0; m < model.members.size(); ++m) {
        if (stiffness_of(*session.solution().task, femoop::MemberId(m)) == 0.0) continue;
        const auto& nodes = model.members[m].nodes;
        const ui::Point middle = 0.5 * (drawn.nodes[nodes[0].index].at + drawn.nodes[nodes[1].index].at);
        nearest.consider(femoop::MemberId(m), ui::distance(middle, nearest.at()));
    }
}

bool can_be_typed(const Session& session, const Drawn& drawn)
{
    return session.solution().task && drawn.nodes.size() == session.document().model.nodes.size();
}

std::optional<TypedValue> value_of(const Session& session, const Drawn& drawn, const WrittenText& written)
{
    Nearest nearest(written.box.center());
    consider_stiffnesses(nearest, session, drawn, written.text);
    if (!nearest.found) consider_loads(nearest, session, drawn, written.text);
    if (!nearest.found) consider_levels(nearest, session, drawn, written);
    return nearest.found;
}

/// What a check says of it.
Typed sound(Model model, const Session& session)
{
    for (const femoop::Fault& fault : frame::named(femoop::check(model), model))
        if (is_error(fault)) return Message("{reason}", {{"reason", fault_text(fault, session.tr())}});
    return model;
}

Message refusal(const femoop::Fault& fault, const Session& session)
{
    std::string reason = fault_text(fault, session.tr());
    if (reason.starts_with(": ")) reason.erase(0, 2); // the place, which the field itself shows
    return {"{reason}", {{"reason", reason}}};
}

// ---- loads

/// The other way round: "-(12) kN".
std::string reversed(std::string_view text)
{
    const auto number = ui::leading_number(text);
    if (!number) return std::string(text);
    return "-(" + std::string(text.substr(0, number->length)) + ")" + std::string(text.substr(number->length));
}

template <class Components> void drop_zeros(Components& components)
{
    std::erase_if(components, [](const femoop::Component& one) { return one.value.value() == 0.0; });
}

/// Without loads that are 0 in every component.
void drop_nothings(femoop::LoadCase& load_case)
{
    std::erase_if(load_case.nodes, [](femoop::NodeLoad& load) {
        drop_zeros(load.components);
        return load.components.empty();
    });
    std::erase_if(load_case.members, [](femoop::MemberLoad& load) {
        if (auto* const point = std::get_if<femoop::PointLoad>(&load.load)) {
            drop_zeros(point->components);
            return point->components.empty();
        }
        auto* const line = std::get_if<femoop::DistributedLoad>(&load.load);
        if (line == nullptr) return false;
        std::erase_if(line->values, [](const auto& one) {
            return one.start.value() == 0.0 && (!one.end || one.end->value() == 0.0);
        });
        return line->values.empty();
    });
}

Typed with_load(const Session& session, const frame::NumberId& id, std::string_view text)
{
    frame::Document document{.model = unverified(session.document().model)};
    const frame::Number number = frame::numbers(document.model, id.part).at(id.place);
    const bool is_downwards = number.value && number.value->value() < 0.0;
    const std::string own = text.find_first_not_of(' ') == std::string_view::npos ? "0" : std::string(text);
    const auto read = [&](const std::string& one) {
        return frame::quantity_typed(one, number.measure, document.model.units, units_in(session));
    };
    const auto typed = read(own);
    if (const auto* const fault = std::get_if<femoop::Fault>(&typed)) return refusal(*fault, session);
    const auto value = std::get<femoop::Quantity>(is_downwards ? read(reversed(own)) : typed);
    frame::set_number(document, id, value);
    if (value.value() == 0.0) drop_nothings(document.model.load_cases.at(frame::load_case_of(id.part)));
    return sound(std::move(document.model), session);
}

// ---- lengths

Typed with_length(const Session& session, const Level& level, std::string_view text)
{
    Model model = unverified(session.document().model);
    const auto typed = frame::quantity_typed(text, Measure::Length, model.units, units_in(session));
    if (const auto* const fault = std::get_if<femoop::Fault>(&typed)) return refusal(*fault, session);
    const double length = std::get<femoop::Quantity>(typed).value(), by = length - (level.high - level.low);
    if (!(length > 0.0)) return Message(translatable("a length is more than 0"));
    const auto axis = static_cast<std::size_t>(level.axis);
    const double from = level.high - 0.5 * (level.high - level.low);
    for (femoop::Node& node : model.nodes)
        if (node.at[axis].value() > from)
            node.at[axis] = femoop::Quantity(std::stod(ui::number_text(node.at[axis].value() + by, {exact_digits})));
    return sound(std::move(model), session);
}

// ---- bending stiffness

ui::DisplayUnit stiffness_unit(const ui::DisplayUnits& units)
{
    const ui::DisplayUnit force = units.unit(Measure::Force), length = units.unit(Measure::Length);
    return {force.name + "·" + length.name + "²", force.factor * length.factor * length.factor};
}

/// "2 EI", "EI": so many times the smallest.
std::optional<double> multiple(const Session& session, std::string_view text)
{
    const std::size_t at = text.find("EI");
    if (at == std::string_view::npos || text.find_first_not_of(' ', at + 2) != std::string_view::npos)
        return std::nullopt;
    const std::string_view number = text.substr(0, at);
    const bool is_one = number.find_first_not_of(' ') == std::string_view::npos;
    const auto times = is_one ? std::optional(1.0) : ui::number_typed(number);
    if (!times) return std::nullopt;
    return *times * smallest_stiffness(*session.solution().task);
}

/// A section of its own where others have it too.
femoop::Section& own_section(Model& model, femoop::MemberId member)
{
    const femoop::SectionId before = *model[member].section;
    const auto has_it = [&](const femoop::Member& one) { return one.section == before; };
    if (std::ranges::count_if(model.members, has_it) == 1) return model.sections[before.index];
    femoop::Section copy = model[before];
    copy.id = femoop::fresh_id(model.sections, copy.id);
    model.members[member.index].section = model.add(std::move(copy));
    return model.sections[model.members[member.index].section->index];
}

Typed with_stiffness(const Session& session, femoop::MemberId member, std::string_view text)
{
    Model model = unverified(session.document().model);
    constexpr femoop::Dimension dimension{.length = 2, .force = 1};
    std::optional<double> EI = multiple(session, text);
    if (!EI) {
        const auto typed = frame::quantity_typed(text, dimension, model.units, stiffness_unit(units_in(session)));
        if (const auto* const fault = std::get_if<femoop::Fault>(&typed)) return refusal(*fault, session);
        EI = std::get<femoop::Quantity>(typed).value();
    }
    if (!(*EI > 0.0)) return Message(translatable("EI is more than 0"));
    if (!model[member].section || !model[member].material) return Message(translatable("this member has no section"));
    const double E = model[*model[member].material].E.value();
    own_section(model, member).Iz = femoop::Quantity(*EI / E);
    return sound(std::move(model), session);
}

frame::NumberId first_number(const frame::Part& part) { return {.part = part, .place = 0}; }

} // namespace

std::optional<TypedValue> written_at(const Session& session, const Drawn& drawn, ui::Point at)
{
    if (!can_be_typed(session, drawn)) return std::nullopt;
    for (const WrittenText& written : drawn.texts)
        if (written.box.grown(2.0).contains(at))
            if (const auto value = value_of(session, drawn, written)) return value;
    return std::nullopt;
}

namespace {

double distance_to(const ui::Box& box, ui::Point at)
{
    return std::hypot(std::max({box.min.x - at.x, at.x - box.max.x, 0.0}),
                      std::max({box.min.y - at.y, at.y - box.max.y, 0.0}));
}

std::optional<TypedValue> written_near(const Session& session, const Drawn& drawn, ui::Point at)
{
    constexpr double finger = 9.0; // [px] beside what it means, in the theme's symbols
    if (!can_be_typed(session, drawn)) return std::nullopt;
    double nearest = finger * ui::Theme(session.look.theme).symbol_scale();
    std::optional<TypedValue> found;
    for (const WrittenText& written : drawn.texts) {
        const double distance = distance_to(written.box, at);
        if (distance >= nearest) continue;
        const auto value = value_of(session, drawn, written);
        if (!value) continue;
        nearest = distance;
        found = value;
    }
    return found;
}

} // namespace

std::optional<TypedValue> value_at(const Session& session, const Drawn& drawn, ui::Point at)
{
    if (const auto written = written_at(session, drawn, at)) return written;
    if (const auto near = written_near(session, drawn, at)) return near;
    const drawing::LoadMark* const load = drawn.is_in_structure(at) ? pick_load(drawn, at) : nullptr;
    return load != nullptr ? largest_of(session, load->load) : std::nullopt;
}

std::string text_of(const Session& session, const TypedValue& value)
{
    const ui::DisplayUnits units = units_in(session);
    const auto exact = [&](double shown) { return ui::number_text(shown, {exact_digits, units.format().mark}); };
    if (const auto* const level = std::get_if<Level>(&value))
        return exact(units.shown(level->high - level->low, Measure::Length)) + " " + units.unit(Measure::Length).name;
    if (const auto* const member = std::get_if<femoop::MemberId>(&value)) {
        const ui::DisplayUnit unit = stiffness_unit(units);
        return exact(stiffness_of(*session.solution().task, *member) * unit.factor) + " " + unit.name;
    }
    const auto& id = std::get<frame::NumberId>(value);
    const frame::Number number = frame::numbers(session.document().model, id.part).at(id.place);
    return exact(units.shown(std::abs(*number.value), number.measure)) + " " + units.unit(number.measure).name;
}

Typed with_value(const Session& session, const TypedValue& value, std::string_view text)
{
    return std::visit(
        [&](const auto& one) {
            using Value = std::remove_cvref_t<decltype(one)>;
            if constexpr (std::is_same_v<Value, frame::NumberId>) return with_load(session, one, text);
            else if constexpr (std::is_same_v<Value, Level>) return with_length(session, one, text);
            else return with_stiffness(session, one, text);
        },
        value);
}

NewLoad with_uniform_load(const Session& session, femoop::MemberId member)
{
    frame::Document document{.model = unverified(session.document().model)};
    femoop::DistributedLoad load;
    const double q = units_in(session).stored(usual_uniform, Measure::ForcePerLength);
    load.values.push_back({.dof = femoop::Dof::uy, .start = femoop::Quantity(-q), .end = {}});
    const auto load_case = frame::load_case_for(document, session.document().method.load_case);
    const frame::Part part = frame::add_member_load(document, load_case, member, load);
    return {std::move(document.model), first_number(part)};
}

NewLoad with_point_load(const Session& session, femoop::MemberId member, double x)
{
    frame::Document document{.model = unverified(session.document().model)};
    const double P = units_in(session).stored(usual_force, Measure::Force);
    const femoop::PointLoad load{.at = femoop::Quantity(x), .components = {{femoop::Dof::uy, femoop::Quantity(-P)}}};
    const auto load_case = frame::load_case_for(document, session.document().method.load_case);
    const frame::Part part = frame::add_member_load(document, load_case, member, load);
    return {std::move(document.model), first_number(part)};
}

NewLoad with_node_load(const Session& session, femoop::NodeId node)
{
    frame::Document document{.model = unverified(session.document().model)};
    const std::vector<double> across = levels(document.model, 0);
    const bool is_right = place_of(document.model, node).x() > 0.5 * (across.front() + across.back());
    const femoop::Dof dof = is_level(document.model) ? femoop::Dof::uy : femoop::Dof::ux;
    const double sign = dof == femoop::Dof::uy || is_right ? -1.0 : 1.0;
    const double P = sign * units_in(session).stored(usual_force, Measure::Force);
    const auto load_case = frame::load_case_for(document, session.document().method.load_case);
    const frame::Part part = frame::add_node_load(document, load_case, node, {dof, femoop::Quantity(P)});
    const auto place = std::get<frame::NodeLoadPlace>(part);
    const auto& components = document.model.load_cases[place.load_case].nodes[place.load].components;
    const auto at = std::ranges::find(components, dof, &femoop::Component::dof) - components.begin();
    return {std::move(document.model), {.part = part, .place = static_cast<std::size_t>(at)}};
}

} // namespace cross
