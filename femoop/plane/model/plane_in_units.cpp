#include "femoop/plane/model/plane_in_units.h"

#include <cstdint>
#include <optional>
#include <variant>

#include "femoop/model/quantity/dof_dimension.h"
#include "femoop/model/quantity/in_units.h"

namespace femoop::plane {

namespace {

constexpr Dimension force_per_volume{.length = -3, .force = 1};

/// Recounts every quantity of a plane model, part by part, in place.
class PlaneRecount {
public:
    PlaneRecount(const PlaneModel& model, const Units& to)
        : from_(model.units), to_(to), has_usual_thickness_(model.analysis == StressState::PlaneStrain)
    {}

    void part(PlanePoint& point) const
    {
        place(point.at);
        number(point.size, dimension::length);
        if (point.support)
            for (Spring& spring : point.support->springs) number(spring.stiffness, spring_dimension(spring.dof));
    }

    void part(PlaneCurve& curve) const
    {
        if (curve.support)
            for (Spring& spring : curve.support->springs)
                number(spring.stiffness, times_length(spring_dimension(spring.dof), -2));
        if (!curve.shape) return;
        DrawnShape& shape = *curve.shape;
        for (DrawnPlace& drawn : shape.places) place(drawn);
        if (shape.center) place(*shape.center);
        number(shape.radius, dimension::length);
        for (Quantity& axis : shape.axes) number(axis, dimension::length);
    }

    void part(PlaneRegion& region) const
    {
        for (auto& at : region.at) place(at);
        if (!region.thickness && has_usual_thickness_ && !region.is_hole) region.thickness = Quantity(1.0);
        number(region.thickness, dimension::length);
        part(region.mesh);
    }

    void part(MeshOptions& mesh) const { number(mesh.size, dimension::length); }

    void part(PlaneLoadCase& loads) const
    {
        for (NodeLoad& load : loads.points)
            for (Component& force : load.components) number(force.value, dimension::force);
        for (CurveLoad& load : loads.curves) {
            const Dimension of_load = load.kind == CurveLoadKind::Line ? dimension::force_per_length
                                                                       : dimension::stress;
            for (auto* field : {&load.qx, &load.qy, &load.value}) this->field(*field, of_load);
        }
        for (RegionLoad& load : loads.regions) std::visit([this](auto& kind) { this->load(kind); }, load.load);
        for (PlaneSettlement& settlement : loads.settlements)
            for (auto* field : {&settlement.ux, &settlement.uy}) this->field(*field, dimension::length);
    }

    void part(PlaneExpected& check) const
    {
        number(check.value, dimension_of(check));
        number(check.atol, dimension_of(check));
        for (auto* lengths : {&check.at, &check.about, &check.cut}) this->lengths(*lengths);
    }

    void number(std::optional<Quantity>& quantity, Dimension dimension) const
    {
        if (quantity) number(*quantity, dimension);
    }

private:
    static Dimension times_length(Dimension dimension, int power)
    {
        dimension.length = static_cast<std::int8_t>(dimension.length + power);
        return dimension;
    }

    void number(Quantity& quantity, Dimension dimension) const { quantity = in_units(quantity, dimension, from_, to_); }
    void lengths(std::vector<Quantity>& all) const
    {
        for (Quantity& one : all) number(one, dimension::length);
    }
    void place(std::array<Quantity, 2>& at) const
    {
        for (Quantity& coordinate : at) number(coordinate, dimension::length);
    }
    void place(DrawnPlace& drawn) const
    {
        if (!drawn.point) place(drawn.at);
    }

    void load(BodyForce& load) const
    {
        field(load.bx, force_per_volume);
        field(load.by, force_per_volume);
    }
    void load(TemperatureRise& load) const { field(load.rise, dimension::temperature); }
    void load(SteadyRotation& load) const { lengths(load.about); }

    void field(std::optional<Field>& field, Dimension dimension) const
    {
        if (field) std::visit([&](auto& form) { recount(form, dimension); }, field->form);
    }
    void recount(Quantity& constant, Dimension dimension) const { number(constant, dimension); }
    void recount(Field::Ends& ends, Dimension dimension) const
    {
        number(ends.start, dimension);
        number(ends.end, dimension);
    }
    void recount(Field::Polynomial& terms, Dimension dimension) const
    {
        for (Field::Term& term : terms) number(term.factor, times_length(dimension, -(term.i + term.j)));
    }
    void recount(Field::Table& table, Dimension dimension) const
    {
        lengths(table.about);
        for (auto& [at, value] : table.rows) {
            number(at, dimension::length);
            number(value, dimension);
        }
    }

    Units from_, to_;
    bool has_usual_thickness_; ///< a region without one is 1 thick, which is another thickness in other units
};

} // namespace

PlaneModel in_units(const PlaneModel& model, const Units& units)
{
    PlaneModel other = model;
    const PlaneRecount recount(model, units);
    recount.number(other.snap, dimension::length);
    recount.part(other.mesh);
    for (Material& material : other.materials) material = in_units(material, model.units, units);
    for (PlanePoint& point : other.points) recount.part(point);
    for (PlaneCurve& curve : other.curves) {
        recount.part(curve);
        if (!curve.reach) continue;
        curve.reach->length = in_units(Quantity(curve.reach->length), dimension::length, model.units, units);
        for (CurveReach::Run& run : curve.reach->runs)
            run.start = in_units(Quantity(run.start), dimension::length, model.units, units);
    }
    for (PlaneRegion& region : other.regions) recount.part(region);
    for (PlaneLoadCase& loads : other.load_cases) recount.part(loads);
    for (PlaneExpected& check : other.expected) recount.part(check);
    other.units = units;
    return other;
}

} // namespace femoop::plane
