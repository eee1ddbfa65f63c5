#include "femoop/model/quantity/in_units.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/dof_dimension.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/quantity_parser.h"

namespace femoop {

namespace {

/// Recounts every quantity of a model, part by part, in place.
class Recount {
public:
    Recount(const Units& from, const Units& to) : from_(from), to_(to) {}

    void part(Section& section) const
    {
        number(section.A, dimension::area);
        for (auto* second_moment : {&section.Iz, &section.Iy, &section.J})
            number(*second_moment, dimension::second_moment);
        for (auto* area : {&section.Asy, &section.Asz}) number(*area, dimension::area);
        for (auto* length : {&section.h, &section.yc}) number(*length, dimension::length);
        if (!section.shape) return;
        SectionShape& shape = *section.shape;
        for (auto* size : {&shape.b, &shape.h, &shape.d, &shape.t, &shape.bf, &shape.tf, &shape.tw})
            number(*size, dimension::length);
    }

    void part(Node& node) const
    {
        for (Quantity& coordinate : node.at) number(coordinate, dimension::length);
        for (Component& mass : node.mass) number(mass.value, mass_dimension(mass.dof));
        if (node.support) springs(node.support->springs);
    }

    void part(Member& member) const
    {
        for (MemberEnd* end : {&member.start, &member.end}) {
            springs(end->springs);
            for (Quantity& length : end->offset) number(length, dimension::length);
        }
        for (Quantity& depth : member.depths) number(depth, dimension::length);
        number(member.foundation, dimension::stress);
    }

    void part(LoadCase& loads) const
    {
        for (NodeLoad& load : loads.nodes) forces(load.components);
        for (Settlement& settlement : loads.settlements)
            for (Component& u : settlement.components) number(u.value, displacement_dimension(u.dof));
        for (MemberLoad& load : loads.members) std::visit([this](auto& kind) { this->load(kind); }, load.load);
    }

    void part(Expected& check) const
    {
        number(check.value, dimension_of(check));
        number(check.atol, dimension_of(check));
        position(check.at);
    }

    void part(InfluenceLineDefinition& line) const { position(line.effect.at); }

    void part(Train& train) const
    {
        const Dof along = train.load.empty() ? Dof::uy : train.load.front().dof;
        for (Quantity& axle : train.axles) number(axle, force_dimension(along));
        for (Quantity& spacing : train.spacings) number(spacing, dimension::length);
        for (SpacingRange& range : train.spacing_ranges) {
            number(range.min, dimension::length);
            number(range.max, dimension::length);
        }
        number(train.uniform, line_load_dimension(along));
        number(train.gap, dimension::length);
        for (ConcentratedForce& force : train.concentrated) {
            number(force.for_moments, force_dimension(along));
            number(force.for_others, force_dimension(along));
        }
    }

private:
    void number(Quantity& quantity, Dimension dimension) const { quantity = in_units(quantity, dimension, from_, to_); }
    void number(std::optional<Quantity>& quantity, Dimension dimension) const
    {
        if (quantity) number(*quantity, dimension);
    }
    void position(Position& position) const
    {
        if (auto* length = std::get_if<Quantity>(&position)) number(*length, dimension::length);
    }
    void position(std::optional<Position>& maybe) const
    {
        if (maybe) position(*maybe);
    }
    void springs(std::vector<Spring>& springs) const
    {
        for (Spring& spring : springs) number(spring.stiffness, spring_dimension(spring.dof));
    }
    void forces(std::vector<Component>& components) const
    {
        for (Component& force : components) number(force.value, force_dimension(force.dof));
    }

    void load(DistributedLoad& load) const
    {
        for (DistributedLoad::Value& value : load.values) {
            number(value.start, line_load_dimension(value.dof));
            number(value.end, line_load_dimension(value.dof));
        }
        position(load.from);
        position(load.to);
    }
    void load(PointLoad& load) const
    {
        position(load.at);
        forces(load.components);
    }
    void load(EndLoads& load) const
    {
        forces(load.start);
        forces(load.end);
    }
    void load(TemperatureLoad& /*load*/) const {}
    void load(Misfit& misfit) const { number(misfit.elongation, dimension::length); }

    Units from_, to_;
};

} // namespace

Quantity in_units(const Quantity& quantity, Dimension dimension, const Units& from, const Units& to)
{
    if (dimension.length == 0 && dimension.force == 0) return quantity;
    const bool is_typed = quantity.has_text();
    // As a person converts: the digits that are written, not their binary neighbours, so that 0.0002 m^4 is 2e8 mm^4.
    const std::string text = is_typed ? std::string(quantity.text()) : quantity_text(quantity.value(), dimension, from);
    const auto read = parse_quantity(text, dimension, to);
    const double* parsed = std::get_if<double>(&read);
    const double value = parsed ? *parsed : converted(quantity.value(), dimension, from, to);
    return is_typed ? Quantity(value, text) : Quantity(value);
}

Material in_units(const Material& material, const Units& from, const Units& to)
{
    Material other = material;
    const auto number = [&](std::optional<Quantity>& quantity, Dimension dimension) {
        if (quantity) quantity = in_units(*quantity, dimension, from, to);
    };
    other.E = in_units(material.E, dimension::stress, from, to);
    number(other.G, dimension::stress);
    number(other.fy, dimension::stress);
    number(other.density, dimension::density);
    return other;
}

Model in_units(const Model& model, const Units& units)
{
    if (!model.extra.empty())
        throw std::invalid_argument("in_units: block \"" + model.extra.front().key + "\" cannot be recounted");
    Model other = model;
    const Recount recount(model.units, units);
    for (Material& material : other.materials) material = in_units(material, model.units, units);
    for (Section& section : other.sections) recount.part(section);
    for (Node& node : other.nodes) recount.part(node);
    for (Member& member : other.members) recount.part(member);
    for (LoadCase& loads : other.load_cases) recount.part(loads);
    for (InfluenceLineDefinition& line : other.moving_loads.influence_lines) recount.part(line);
    for (Train& train : other.moving_loads.trains) recount.part(train);
    for (Expected& check : other.expected) recount.part(check);
    other.units = units;
    return other;
}

} // namespace femoop
