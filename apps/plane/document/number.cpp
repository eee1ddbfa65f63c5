#include "apps/plane/document/number.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/plane/document/attributes.h"
#include "apps/plane/document/points.h"
#include "ui/text/catalogue.h"

namespace plane {

using femoop::Dof;
using femoop::Quantity;
using femoop::plane::BodyForce;
using femoop::plane::CurveLoad;
using femoop::plane::CurveLoadKind;
using femoop::plane::Division;
using femoop::plane::DrawnShape;
using femoop::plane::Field;
using femoop::plane::SteadyRotation;
using femoop::plane::TemperatureRise;
using ui::Measure;
using ui::Message;
using ui::translatable;

namespace {

using Value = std::optional<Quantity>;
using Objection = std::optional<Message>;

/// A number that a document has in one place: `find(document)` is the address of a Quantity or of an optional one.
template <class Find>
Number number_at(std::string id, Message label, Measure measure, const PlaneModel& model, Find find)
{
    const auto* const place = find(model);
    using Place = std::remove_cvref_t<decltype(*place)>;
    constexpr bool is_optional = std::is_same_v<Place, Value>;
    return {std::move(id),
            std::move(label),
            measure,
            Value(*place),
            is_optional,
            [find](Document& document, const Value& value) -> Objection {
                auto* const there = find(document.model);
                if constexpr (is_optional) {
                    *there = value;
                } else {
                    if (!value) return Message(translatable("a value is needed here"));
                    *there = *value;
                }
                return std::nullopt;
            }};
}

Number coordinate(const PlaneModel& model, NodeId point, std::size_t axis)
{
    return {axis == 0 ? "x" : "y",
            Message(axis == 0 ? "x" : "y"),
            Measure::Length,
            model[point].at[axis],
            false,
            [point, axis](Document& document, const Value& value) -> Objection {
                if (!value) return Message(translatable("a value is needed here"));
                FlatPoint to = place_of(document.model, point);
                (axis == 0 ? to.x : to.y) = *value;
                move_point(document, point, to);
                document.model.points[point.index].at[axis] = *value; // as it was typed
                return std::nullopt;
            }};
}

Number force(const PlaneModel& model, NodeId point, std::size_t load_case, Dof dof)
{
    const bool is_x = dof == Dof::ux;
    return {is_x ? "fx" : "fy",
            is_x ? "Fx" : "Fy",
            Measure::Force,
            force_on(model, load_case, point, dof),
            true,
            [=](Document& document, const Value& value) -> Objection {
                set_force(document, load_case, point, dof, value);
                return std::nullopt;
            }};
}

/// Angle and springs of a support of the object form. `holder` is where in a model the support is.
template <class Holder>
void add_support(std::vector<Number>& all, const PlaneModel& model, Holder holder, Measure of_spring)
{
    const auto& support = holder(model).support;
    if (!support || support->kind != PlaneSupportKind::Custom) return;
    if (!support->is_local)
        all.push_back(number_at("angle of support", translatable("Angle of the support"), Measure::Angle, model,
                                [holder](auto& of) { return &holder(of).support->angle; }));
    for (const Dof dof : {Dof::ux, Dof::uy}) {
        const auto there = std::ranges::find(support->springs, dof, &femoop::Spring::dof);
        const Value stiffness = there != support->springs.end() ? Value(there->stiffness) : std::nullopt;
        const std::string name(femoop::name(dof));
        all.push_back({"spring " + name, Message(translatable("Spring {dof}"), {{"dof", name}}), of_spring, stiffness,
                       true, [holder, dof](Document& document, const Value& value) -> Objection {
                           set_spring(*holder(document.model).support, dof, value);
                           return std::nullopt;
                       }});
    }
}

DrawnShape& shape_in(Document& document, CurveId curve) { return document.model.curves[curve.index].shape.value(); }

Number parts_number(const PlaneModel& model, CurveId curve)
{
    const auto& divide = model[curve].shape->divide;
    const Value n = divide.size() == 1 ? Value(Quantity(divide.front().n)) : std::nullopt;
    return {"divisions",
            translatable("Divisions n"),
            Measure::Plain,
            n,
            true,
            [curve](Document& document, const Value& value) -> Objection {
                if (!value) {
                    set_division(document, curve, std::nullopt);
                    return std::nullopt;
                }
                constexpr double most = 10000.0;
                if (!(*value >= 1.0) || *value > most || value->value() != std::round(value->value()))
                    return Message(translatable("divisions are a whole number from 1 to 10000"));
                const auto& given = shape_in(document, curve).divide;
                Division division = given.size() == 1 ? given.front() : Division{};
                division.n = static_cast<int>(value->value());
                set_division(document, curve, division);
                return std::nullopt;
            }};
}

Number ratio_number(const PlaneModel& model, CurveId curve)
{
    const auto& divide = model[curve].shape->divide;
    return {"ratio",
            translatable("Ratio, last to first part"),
            Measure::Plain,
            divide.size() == 1 ? divide.front().ratio : std::nullopt,
            true,
            [curve](Document& document, const Value& value) -> Objection {
                auto& given = shape_in(document, curve).divide;
                if (given.size() != 1) return Message(translatable("give the divisions first"));
                if (value && !(*value > 0.0)) return Message(translatable("a ratio is greater than 0"));
                given.front().ratio = value;
                return std::nullopt;
            }};
}

void add_shape(std::vector<Number>& all, const PlaneModel& model, CurveId curve)
{
    const auto shape = [curve](auto& of) -> auto& { return *of.curves[curve.index].shape; };
    if (model[curve].shape->radius)
        all.push_back(number_at("radius", translatable("Radius"), Measure::Length, model,
                                [shape](auto& of) { return &*shape(of).radius; }));
    if (model[curve].shape->kind != femoop::plane::DrawnKind::Ellipse) return;
    for (const std::size_t i : {0U, 1U})
        if (i < model[curve].shape->axes.size())
            all.push_back(number_at(i == 0 ? "a" : "b",
                                    Message(i == 0 ? translatable("Half axis a") : translatable("Half axis b")),
                                    Measure::Length, model, [shape, i](auto& of) { return &shape(of).axes[i]; }));
    all.push_back(number_at("angle", translatable("Angle of a"), Measure::Angle, model,
                            [shape](auto& of) { return &shape(of).angle; }));
}

/// What a field counts, and how it is called.
struct FieldName {
    std::string name; ///< in scenarios
    std::string q;    ///< its symbol
    Measure measure = Measure::Plain;
    bool has_ends = false; ///< along a curve: another value at its end can be given
    bool can_go = false;   ///< else what is taken away is 0
    std::string_view label = "{q}", end_label = translatable("{q} at the end, if another");
};

Value value_of(const std::optional<Field>& field, bool is_end)
{
    if (!field) return std::nullopt;
    if (const auto* const same = std::get_if<Quantity>(&field->form)) return is_end ? std::nullopt : Value(*same);
    const auto* const ends = std::get_if<Field::Ends>(&field->form);
    if (ends == nullptr) return std::nullopt;
    return is_end ? ends->end : ends->start;
}

/// The value at the end is that at the start where it is not given.
void set_value(std::optional<Field>& field, bool is_end, const Value& value)
{
    const Quantity start = value_of(field, false).value_or(Quantity(0.0));
    const Value end = value_of(field, true);
    if (is_end) field = value ? Field{Field::Ends{start, *value}} : Field{start};
    else if (end) field = Field{Field::Ends{value.value_or(Quantity(0.0)), *end}};
    else field = Field{value.value_or(Quantity(0.0))};
}

bool is_in_numbers(const std::optional<Field>& field)
{
    return !field || std::holds_alternative<Quantity>(field->form) || std::holds_alternative<Field::Ends>(field->form);
}

/// One number of a field that is the same everywhere, along a curve another one for its end, or the field that varies
/// otherwise. `change(document, edit)` edits it there.
template <class Change>
void add_field(std::vector<Number>& all, const FieldName& of, const std::optional<Field>& shown, Change change)
{
    const bool is_plain = is_in_numbers(shown);
    for (const bool is_end : {false, true}) {
        if (is_end && !(of.has_ends && is_plain)) continue;
        const Message label(is_end ? of.end_label : of.label, {{"q", of.q}});
        Number number{of.name + (is_end ? " end" : ""),
                      label,
                      of.measure,
                      value_of(shown, is_end),
                      true,
                      [=, can_go = of.can_go](Document& document, const Value& value) -> Objection {
                          change(document, [&](std::optional<Field>& field) {
                              const bool goes = can_go && !value && !is_end && !value_of(field, true);
                              if (goes) field.reset();
                              else set_value(field, is_end, value);
                          });
                          return std::nullopt;
                      }};
        if (!is_end)
            number.set_field = [change](Document& document, const Field& given) {
                change(document, [&](std::optional<Field>& field) { field = given; });
            };
        if (!is_plain) number.field = shown;
        all.push_back(std::move(number));
    }
}

/// Where a rotating body turns about: the origin until it is given.
Number axis_coordinate(const SteadyRotation& shown, std::size_t axis,
                       const std::function<SteadyRotation&(Document&)>& own)
{
    const bool is_given = shown.about.size() == 2;
    return {axis == 0 ? "about x" : "about y",
            axis == 0 ? translatable("x of the axis") : translatable("y of the axis"),
            Measure::Length,
            is_given ? Value(shown.about[axis]) : std::nullopt,
            true,
            [axis, own](Document& document, const Value& value) -> Objection {
                std::vector<Quantity>& about = own(document).about;
                about.resize(2, Quantity(0.0));
                about[axis] = value.value_or(Quantity(0.0));
                if (about[0].value() == 0.0 && about[1].value() == 0.0) about.clear();
                return std::nullopt;
            }};
}

void add_rotation(std::vector<Number>& all, const PlaneModel& model, const SteadyRotation& shown,
                  const std::function<SteadyRotation&(Document&)>& own)
{
    all.push_back({"omega", translatable("Angular velocity ω"), Measure::AngularVelocity, shown.omega, false,
                   [own](Document& document, const Value& value) -> Objection {
                       if (!value) return Message(translatable("a value is needed here"));
                       own(document).omega = *value;
                       return std::nullopt;
                   }});
    // the axis of revolution is given; another place, which is a fault, can be taken away
    if (model.analysis == femoop::StressState::Axisymmetric && shown.about.empty()) return;
    for (const std::size_t axis : {0U, 1U}) all.push_back(axis_coordinate(shown, axis, own));
}

/// Of a case; a combination has no loads of its own. Where there is no case yet, the first load makes one.
bool is_case(const PlaneModel& model, std::size_t load_case)
{
    return load_case < std::max<std::size_t>(model.load_cases.size(), 1);
}

bool is_held(const std::optional<PlaneSupport>& support, Dof dof)
{
    return support && (support->blocked().contains(dof) ||
                       std::ranges::find(support->springs, dof, &femoop::Spring::dof) != support->springs.end());
}

/// Of the directions that are held, and of others that the file moves: those are faults, and can be taken away.
template <class Id>
void add_settlements(std::vector<Number>& all, const PlaneModel& model, Id part, std::size_t load_case)
{
    if (!is_case(model, load_case)) return;
    for (const Dof dof : {Dof::ux, Dof::uy}) {
        const std::optional<Field> shown = settlement_of(model, load_case, part, dof);
        if (!shown && !is_held(model[part].support, dof)) continue;
        const std::string q(femoop::name(dof));
        add_field(all,
                  {.name = "settlement " + q,
                   .q = q,
                   .measure = Measure::Displacement,
                   .has_ends = std::is_same_v<Id, CurveId>,
                   .can_go = true,
                   .label = translatable("Settlement {q}"),
                   .end_label = translatable("Settlement {q} at the end, if another")},
                  shown, [=](Document& document, const FieldEdit& edit) {
                      change_settlement(document, load_case, part, dof, edit);
                  });
    }
}

} // namespace

Message form_of(const Field& field)
{
    if (const auto* const terms = std::get_if<Field::Polynomial>(&field.form))
        return {translatable("polynomial, terms: {count}"), {{"count", std::to_string(terms->size())}}};
    if (const auto* const table = std::get_if<Field::Table>(&field.form)) {
        constexpr const char* along[] = {"x", "y", "r", "s"}; // Field::Along
        return {
            translatable("table along {along}, rows: {count}"),
            {{"along", along[static_cast<std::size_t>(table->along)]}, {"count", std::to_string(table->rows.size())}}};
    }
    return translatable("a number");
}

std::vector<Number> numbers(const PlaneModel& model, NodeId point, std::size_t load_case)
{
    std::vector<Number> all{coordinate(model, point, 0), coordinate(model, point, 1)};
    const auto holder = [point](auto& of) -> auto& { return of.points[point.index]; };
    add_support(all, model, holder, Measure::ForcePerLength);
    add_settlements(all, model, point, load_case);
    if (is_case(model, load_case))
        for (const Dof dof : {Dof::ux, Dof::uy}) all.push_back(force(model, point, load_case, dof));
    all.push_back(number_at("size", translatable("Element size"), Measure::Length, model,
                            [holder](auto& of) { return &holder(of).size; }));
    return all;
}

std::vector<Number> numbers(const PlaneModel& model, CurveId curve, std::size_t load_case)
{
    std::vector<Number> all;
    if (!model[curve].shape) return all;
    add_shape(all, model, curve);
    all.push_back(parts_number(model, curve));
    all.push_back(ratio_number(model, curve));
    add_support(
        all, model, [curve](auto& of) -> auto& { return of.curves[curve.index]; }, Measure::ForcePerVolume);
    add_settlements(all, model, curve, load_case);
    return all;
}

std::vector<Number> numbers(const PlaneModel& model, RegionId region)
{
    std::vector<Number> all;
    if (model[region].is_hole) return all;
    const auto place = [region](auto& of) -> auto& { return of.regions[region.index]; };
    if (model.analysis != femoop::StressState::Axisymmetric)
        all.push_back(number_at("thickness", translatable("Thickness"), Measure::Length, model,
                                [place](auto& of) { return &place(of).thickness; }));
    all.push_back(number_at("size", translatable("Element size"), Measure::Length, model,
                            [place](auto& of) { return &place(of).mesh.size; }));
    return all;
}

std::vector<Number> numbers(const PlaneModel& model, MaterialId material)
{
    const auto place = [material](auto& of) -> auto& { return of.materials[material.index]; };
    const auto at = [&](std::string id, std::string_view label, Measure measure, auto member) {
        return number_at(std::move(id), label, measure, model,
                         [place, member](auto& of) { return &(place(of).*member); });
    };
    using femoop::Material;
    return {at("E", translatable("Young's modulus E"), Measure::Stress, &Material::E),
            at("nu", translatable("Poisson's ratio ν"), Measure::Plain, &Material::nu),
            at("density", translatable("Density ρ"), Measure::Density, &Material::density),
            at("alpha", translatable("Thermal expansion α"), Measure::Expansion, &Material::alpha)};
}

std::vector<Number> numbers(const PlaneModel& model, std::size_t load_case, std::size_t nth, CurveId curve)
{
    const CurveLoad& shown = load_on(model, load_case, nth, curve);
    const bool is_line = shown.kind == CurveLoadKind::Line;
    std::vector<Number> all;
    const auto add = [&](const char* name, std::optional<Field> CurveLoad::*field) {
        add_field(
            all,
            {.name = name, .q = name, .measure = is_line ? Measure::ForcePerLength : Measure::Stress, .has_ends = true},
            shown.*field,
            [=](Document& document, const FieldEdit& edit) { edit(own_load(document, load_case, nth, curve).*field); });
    };
    if (shown.kind == CurveLoadKind::Pressure) {
        add("p", &CurveLoad::value);
        return all;
    }
    add("qx", &CurveLoad::qx);
    add("qy", &CurveLoad::qy);
    return all;
}

std::vector<Number> numbers(const PlaneModel& model, std::size_t load_case, std::size_t nth, RegionId region)
{
    const auto& shown = load_on(model, load_case, nth, region).load;
    const auto form = [=]<class Form>(Form* /*of*/) {
        return [=](Document& document) -> Form& {
            return std::get<Form>(own_load(document, load_case, nth, region).load);
        };
    };
    std::vector<Number> all;
    const auto add = [&](const FieldName& of, const auto& load_shown, auto member) {
        using Form = std::remove_cvref_t<decltype(load_shown)>;
        add_field(all, of, load_shown.*member,
                  [own = form(static_cast<Form*>(nullptr)), member](Document& document, const FieldEdit& edit) {
                      edit(own(document).*member);
                  });
    };
    if (const auto* const body = std::get_if<BodyForce>(&shown)) {
        add({.name = "bx", .q = "bx", .measure = Measure::ForcePerVolume}, *body, &BodyForce::bx);
        add({.name = "by", .q = "by", .measure = Measure::ForcePerVolume}, *body, &BodyForce::by);
    }
    if (const auto* const heat = std::get_if<TemperatureRise>(&shown))
        add({.name = "rise", .q = "ΔT", .measure = Measure::Temperature}, *heat, &TemperatureRise::rise);
    if (const auto* const rotation = std::get_if<SteadyRotation>(&shown))
        add_rotation(all, model, *rotation, form(static_cast<SteadyRotation*>(nullptr)));
    return all;
}

namespace {

Number joined(const std::vector<Number>& each)
{
    Number all = each.front();
    for (const Number& other : each) {
        all.differs = all.differs || other.value != all.value || other.field != all.field;
        all.is_optional = all.is_optional && other.is_optional;
    }
    if (all.differs) {
        all.value.reset();
        all.field.reset();
    }
    all.set = [each](Document& document, const Value& value) {
        Objection objection;
        for (std::size_t i = 0; i < each.size() && !objection; ++i) objection = each[i].set(document, value);
        return objection;
    };
    if (all.set_field)
        all.set_field = [each](Document& document, const Field& field) {
            for (const Number& number : each) number.set_field(document, field);
        };
    return all;
}

} // namespace

std::vector<Number> numbers_of_all(const std::vector<std::vector<Number>>& of_parts)
{
    std::vector<Number> all;
    if (of_parts.empty()) return all;
    for (const Number& first : of_parts.front()) {
        std::vector<Number> each;
        for (const std::vector<Number>& of_part : of_parts)
            if (const auto same = std::ranges::find(of_part, first.id, &Number::id); same != of_part.end())
                each.push_back(*same);
        if (each.size() == of_parts.size()) all.push_back(joined(each));
    }
    return all;
}

} // namespace plane
