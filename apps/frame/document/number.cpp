#include "apps/frame/document/number.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include "apps/drawing/measures.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;
using ui::Measure;
using ui::Message;
using ui::translatable;

namespace {

// ---- one visit of all numbers of a part, for reading (const Model) and for writing (Model) ----

Message line_load_label(Dof dof, std::string_view sentence)
{
    static constexpr std::string_view symbols[] = {"qx", "qy", "qz", "mx", "my", "mz"};
    return {sentence, {{"q", std::string(symbols[index(dof)])}}};
}

Message spring_label(std::string_view sentence, Dof dof) { return {sentence, {{"dof", std::string(name(dof))}}}; }

template <class ModelType, class Visit> class NumberVisit {
public:
    NumberVisit(ModelType& model, Visit& visit) : model_(model), visit_(visit) {}

    void operator()(NodeId id)
    {
        auto& node = model_.nodes[id.index];
        static constexpr std::string_view axes[] = {"x", "y", "z"};
        for (std::size_t i = 0; i < n_coordinates(model_.analysis); ++i) visit_(axes[i], Measure::Length, node.at[i]);
        if (!node.support) return;
        if (is_plane(model_.analysis))
            visit_(translatable("Angle of the support"), Measure::Angle, node.support->angle);
        springs(node.support->springs, translatable("Spring {dof}"));
    }

    void operator()(MemberId id)
    {
        auto& member = model_.members[id.index];
        if (member.depths.size() == 2) {
            visit_(translatable("Depth h, start"), Measure::SectionLength, member.depths[0]);
            visit_(translatable("Depth h, end"), Measure::SectionLength, member.depths[1]);
        }
        if (!is_truss(model_.analysis))
            visit_(translatable("Elastic foundation"), Measure::FoundationModulus, member.foundation);
        springs(member.start.springs, translatable("Spring {dof}, start"));
        springs(member.end.springs, translatable("Spring {dof}, end"));
        vector(member.start.offset, translatable("Offset {axis}, start"), Measure::Length);
        vector(member.end.offset, translatable("Offset {axis}, end"), Measure::Length);
        vector(member.up, translatable("Up {axis}"), Measure::Plain);
    }

    void operator()(MaterialId id)
    {
        auto& material = model_.materials[id.index];
        visit_(translatable("Young's modulus E"), Measure::Stress, material.E);
        visit_(translatable("Poisson's ratio ν"), Measure::Plain, material.nu);
        visit_(translatable("Shear modulus G"), Measure::Stress, material.G);
        visit_(translatable("Thermal expansion α"), Measure::Expansion, material.alpha);
        visit_(translatable("Density ρ"), Measure::Density, material.density);
        visit_(translatable("Yield stress fy"), Measure::Stress, material.fy);
    }

    void operator()(SectionId id)
    {
        auto& section = model_.sections[id.index];
        if (section.shape) shape(*section.shape);
        visit_("A", Measure::Area, section.A);
        visit_("Iz", Measure::SecondMoment, section.Iz);
        visit_("Iy", Measure::SecondMoment, section.Iy);
        visit_("J", Measure::SecondMoment, section.J);
        visit_(translatable("Shear area Asy"), Measure::Area, section.Asy);
        visit_(translatable("Shear area Asz"), Measure::Area, section.Asz);
        visit_(translatable("Depth h"), Measure::SectionLength, section.h);
        visit_(translatable("Centroid yc"), Measure::SectionLength, section.yc);
    }

    void operator()(LoadCasePlace p)
    {
        visit_(translatable("Factor of self-weight"), Measure::Plain, model_.load_cases[p.load_case].self_weight);
    }

    void operator()(CombinationPlace p)
    {
        for (auto& term : model_.combinations[p.combination].terms)
            visit_(Message(translatable("Factor of {case}"), {{"case", model_.case_name(term.of)}}), Measure::Plain,
                   term.factor);
    }

    void operator()(NodeLoadPlace p) { components(model_.load_cases[p.load_case].nodes[p.load].components); }

    void operator()(SettlementPlace p)
    {
        auto& settlement = model_.load_cases[p.load_case].settlements[p.settlement];
        for (const Dof dof : all_dofs)
            if (can_settle(settlement.node, dof) || has(settlement.components, dof))
                imposed(settlement.components, dof);
    }

    void operator()(DimensionPlace) {} // is no part of the model

    void operator()(MemberLoadPlace p)
    {
        std::visit([this](auto& load) { this->member_load(load); },
                   model_.load_cases[p.load_case].members[p.load].load);
    }

private:
    static bool has(const std::vector<Component>& list, Dof dof)
    {
        return std::ranges::find(list, dof, &Component::dof) != list.end();
    }

    /// The support holds it or is sprung there.
    bool can_settle(NodeId node, Dof dof) const
    {
        const std::optional<Support>& support = model_.nodes[node.index].support;
        return support && (support->blocked(model_.analysis).contains(dof) ||
                           std::ranges::find(support->springs, dof, &Spring::dof) != support->springs.end());
    }

    /// What is imposed in one direction: given where a number is written, and no more where it is taken away.
    template <class Components> void imposed(Components& list, Dof dof)
    {
        const auto there = std::ranges::find(list, dof, &Component::dof);
        std::optional<Quantity> value = there != list.end() ? std::optional(there->value) : std::nullopt;
        visit_(name(dof), displacement_measures.of(dof), value);
        if constexpr (!std::is_const_v<Components>) {
            if (value && there != list.end()) there->value = *value;
            else if (value) list.push_back({dof, *value});
            else if (there != list.end() && list.size() > 1) list.erase(there);
        }
    }

    template <class Springs> void springs(Springs& list, std::string_view sentence)
    {
        for (auto& spring : list)
            visit_(spring_label(sentence, spring.dof), spring_measures.of(spring.dof), spring.stiffness);
    }

    template <class Quantities> void vector(Quantities& list, std::string_view sentence, Measure measure)
    {
        static constexpr const char* axes[] = {"x", "y", "z"};
        for (std::size_t i = 0; i < list.size() && i < 3; ++i)
            visit_(Message(sentence, {{"axis", axes[i]}}), measure, list[i]);
    }

    template <class Components> void components(Components& list, std::string_view sentence = "{force}")
    {
        for (auto& component : list)
            visit_(Message(sentence, {{"force", std::string(force_name(component.dof))}}),
                   force_measures.of(component.dof), component.value);
    }

    template <class ShapeType> void shape(ShapeType& shape)
    {
        const auto size = [this](std::string_view label, auto& value) {
            if (value) visit_(label, Measure::SectionLength, *value);
        };
        size("b", shape.b);
        size("h", shape.h);
        size("d", shape.d);
        size("t", shape.t);
        size("bf", shape.bf);
        size("tf", shape.tf);
        size("tw", shape.tw);
    }

    template <class PositionType>
    void position(std::string_view length_label, std::string_view percent_label, PositionType& position)
    {
        if (auto* const percent = std::get_if<Percent>(&position)) {
            visit_(percent_label, Measure::Plain, percent->value);
        } else {
            visit_(length_label, Measure::Length, std::get<Quantity>(position));
        }
    }

    template <class Load> void member_load(Load& load)
    {
        using Kind = std::remove_const_t<Load>;
        if constexpr (std::is_same_v<Kind, DistributedLoad>) {
            distributed(load);
        } else if constexpr (std::is_same_v<Kind, PointLoad>) {
            components(load.components);
            position(translatable("Distance from the start"), translatable("Distance from the start [%]"), load.at);
        } else if constexpr (std::is_same_v<Kind, EndLoads>) {
            components(load.start, translatable("{force}, start"));
            components(load.end, translatable("{force}, end"));
        } else if constexpr (std::is_same_v<Kind, TemperatureLoad>) {
            visit_(translatable("Rise at the top"), Measure::Temperature, load.top);
            visit_(translatable("Rise at the bottom"), Measure::Temperature, load.bottom);
        } else {
            visit_(translatable("Elongation"), Measure::Displacement, load.elongation);
        }
    }

    template <class Load> void distributed(Load& load)
    {
        for (auto& value : load.values) {
            const Measure measure = line_load_measures.of(value.dof);
            const std::string_view label = value.end ? translatable("{q}, start") : std::string_view("{q}");
            visit_(line_load_label(value.dof, label), measure, value.start);
            if (value.end) visit_(line_load_label(value.dof, translatable("{q}, end")), measure, *value.end);
        }
        if (load.from) position(translatable("From"), translatable("From [%]"), *load.from);
        if (load.to) position(translatable("To"), translatable("To [%]"), *load.to);
    }

    ModelType& model_;
    Visit& visit_;
};

template <class ModelType, class Visit> void visit_numbers(ModelType& model, const Part& part, Visit&& visit)
{
    std::visit(NumberVisit<ModelType, Visit>(model, visit), part);
}

// Calls change(number) for the one that the id names.
template <class Change> void change_number(Document& document, const NumberId& number, Change&& change)
{
    if (!has(document.model, number.part)) throw std::out_of_range("no such part");
    std::size_t place = 0;
    bool is_found = false;
    visit_numbers(document.model, number.part, [&](const Message&, Measure, auto& value) {
        if (place++ != number.place) return;
        change(value);
        is_found = true;
    });
    if (!is_found) throw std::out_of_range("the part has fewer numbers");
}

} // namespace

std::vector<Number> numbers(const Model& model, const Part& part)
{
    std::vector<Number> all;
    visit_numbers(model, part, [&](const Message& label, Measure measure, const auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        Number number{{part, all.size()}, label, measure, Need::Required, std::nullopt};
        if constexpr (std::is_same_v<Value, std::optional<Quantity>>) {
            number.presence = Need::Optional;
            number.value = value;
        } else {
            number.value = Quantity(value);
        }
        all.push_back(std::move(number));
    });
    return all;
}

namespace {

/// Adds the number of another part that goes by the same name; false where it has none.
bool join(SharedNumber& shared, const std::vector<Number>& others)
{
    const auto same = std::ranges::find(others, shared.of_first.label, &Number::label);
    if (same == others.end()) return false;
    shared.ids.push_back(same->id);
    shared.is_mixed = shared.is_mixed || same->value != shared.of_first.value;
    return true;
}

} // namespace

std::vector<SharedNumber> shared_numbers(const Model& model, std::span<const Part> parts)
{
    std::vector<SharedNumber> shared;
    if (parts.empty()) return shared;
    for (Number& number : numbers(model, parts.front())) shared.push_back({number, {number.id}});
    for (const Part& part : parts.subspan(1)) {
        const std::vector<Number> others = numbers(model, part);
        std::erase_if(shared, [&](SharedNumber& number) { return !join(number, others); });
    }
    return shared;
}

void set_number(Document& document, const NumberId& number, const Quantity& value)
{
    change_number(document, number, [&](auto& place) { place = value; });
}

void clear_number(Document& document, const NumberId& number)
{
    change_number(document, number, [](auto& place) {
        using Value = std::remove_reference_t<decltype(place)>;
        if constexpr (std::is_same_v<Value, std::optional<Quantity>>) {
            place.reset();
        } else {
            throw std::invalid_argument("the number is required");
        }
    });
}

} // namespace frame
