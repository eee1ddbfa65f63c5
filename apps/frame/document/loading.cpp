#include "apps/frame/document/loading.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

#include "femoop/edit/member_line.h"

namespace frame {

using namespace femoop;

LoadCasePlace load_case_for(Document& document, CaseId wanted)
{
    std::vector<LoadCase>& cases = document.model.load_cases;
    if (cases.empty()) {
        const bool is_taken = document.model.find_case("1").has_value(); // by a combination
        document.model.add(LoadCase{.id = is_taken ? "load" : "1"});
    }
    return {wanted.index < cases.size() ? wanted.index : 0};
}

namespace {

/// Adds a component to the entry of the node, which it gets where it has none. \returns the entry's place
template <class Entry> std::size_t add_at_node(std::vector<Entry>& list, NodeId node, const Component& component)
{
    auto found = std::ranges::find(list, node, &Entry::node);
    if (found == list.end()) found = list.insert(list.end(), Entry{node, {}});
    const auto there = std::ranges::find(found->components, component.dof, &Component::dof);
    if (there == found->components.end()) found->components.push_back(component);
    else there->value = Quantity(there->value + component.value);
    return static_cast<std::size_t>(found - list.begin());
}

} // namespace

Part add_node_load(Document& document, LoadCasePlace load_case, NodeId node, const Component& load)
{
    return NodeLoadPlace{load_case.load_case,
                         add_at_node(document.model.load_cases.at(load_case.load_case).nodes, node, load)};
}

Part add_settlement(Document& document, LoadCasePlace load_case, NodeId node, const Component& displacement)
{
    return SettlementPlace{
        load_case.load_case,
        add_at_node(document.model.load_cases.at(load_case.load_case).settlements, node, displacement)};
}

Part add_member_load(Document& document, LoadCasePlace load_case, MemberId member,
                     const decltype(MemberLoad::load)& load)
{
    std::vector<MemberLoad>& loads = document.model.load_cases.at(load_case.load_case).members;
    loads.push_back({member, load});
    return MemberLoadPlace{load_case.load_case, loads.size() - 1};
}

namespace {

/// To a hundredth of the power of ten of what it was: 25.37 to 25.4, 104.9 to 105.
void scale(Quantity& value, double factor)
{
    if (value.value() == 0.0) return;
    const double step = std::pow(10.0, std::floor(std::log10(std::abs(value.value()))) - 2.0);
    const double steps = std::round(value.value() * factor / step);
    const double scaled = step < 1.0 ? steps / std::round(1.0 / step) : steps * step; // 253 / 10, not 253 * 0.1
    if (scaled != value.value()) value = Quantity(scaled); // else it keeps the words that it was written in
}

class Scaling {
public:
    Scaling(Dof dof, double factor) : dof_(dof), factor_(factor) {}

    void operator()(std::vector<Component>& components) const
    {
        for (Component& component : components)
            if (component.dof == dof_) scale(component.value, factor_);
    }
    void operator()(DistributedLoad& load) const
    {
        for (DistributedLoad::Value& value : load.values) {
            if (value.dof != dof_) continue;
            scale(value.start, factor_);
            if (value.end) scale(*value.end, factor_);
        }
    }
    void operator()(PointLoad& load) const { (*this)(load.components); }
    void operator()(EndLoads& load) const
    {
        (*this)(load.start);
        (*this)(load.end);
    }
    void operator()(TemperatureLoad&) const {}
    void operator()(Misfit&) const {}

private:
    Dof dof_;
    double factor_;
};

} // namespace

void scale_load(Document& document, const Part& load, Dof dof, double factor)
{
    std::vector<LoadCase>& cases = document.model.load_cases;
    const Scaling scaling(dof, factor);
    if (const auto* const place = std::get_if<NodeLoadPlace>(&load))
        scaling(cases.at(place->load_case).nodes.at(place->load).components);
    if (const auto* const place = std::get_if<MemberLoadPlace>(&load))
        std::visit(scaling, cases.at(place->load_case).members.at(place->load).load);
}

std::optional<double> place_of_load(const Model& model, const Part& load)
{
    const auto* const place = std::get_if<MemberLoadPlace>(&load);
    if (place == nullptr) return std::nullopt;
    const MemberLoad& on = model.load_cases.at(place->load_case).members.at(place->load);
    const auto* const point = std::get_if<PointLoad>(&on.load);
    if (point == nullptr) return std::nullopt;
    return along(point->at, line_of(model, model[on.member]).length);
}

void place_load(Document& document, const Part& load, double x)
{
    const auto place = std::get<MemberLoadPlace>(load);
    MemberLoad& on = document.model.load_cases.at(place.load_case).members.at(place.load);
    Position& at = std::get<PointLoad>(on.load).at;
    if (std::holds_alternative<Quantity>(at)) at = Quantity(x);
    else at = Percent{100.0 * x / line_of(document.model, document.model[on.member]).length};
}

} // namespace frame
