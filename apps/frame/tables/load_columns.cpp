#include <algorithm>

#include "apps/drawing/measures.h"
#include "apps/frame/document/command.h"
#include "apps/frame/tables/columns.h"
#include "apps/frame/tables/name_column.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;
using ui::Measure;
using ui::Message;
using ui::translatable;

namespace {

Column case_column()
{
    Column column{.heading = translatable("Case"), .read = {}};
    column.read = [](const Model& model, const Part& part) -> CellValue {
        return model.load_cases[load_case_of(part)].id;
    };
    column.write = [](Document& document, const Part& part, const CellText& entry) -> Refusal {
        const auto place = place_of_name(document.model.load_cases, entry);
        if (const auto* const reason = std::get_if<std::string>(&place)) return *reason;
        if (std::get<std::size_t>(place) != load_case_of(part))
            entry.moves.push_back({part, std::get<std::size_t>(place)});
        return std::nullopt;
    };
    return column;
}

constexpr auto node_load = [](auto& model, const Part& part) -> auto&
{
    const auto place = std::get<NodeLoadPlace>(part);
    return model.load_cases[place.load_case].nodes[place.load];
};
constexpr auto settlement = [](auto& model, const Part& part) -> auto&
{
    const auto place = std::get<SettlementPlace>(part);
    return model.load_cases[place.load_case].settlements[place.settlement];
};
constexpr auto member_load = [](auto& model, const Part& part) -> auto&
{
    const auto place = std::get<MemberLoadPlace>(part);
    return model.load_cases[place.load_case].members[place.load];
};
template <class Load> constexpr auto load_as = [](auto& model, const Part& part) -> auto&
{
    return std::get<Load>(member_load(model, part).load);
};

/// The node or member that the load acts on: its name among those of the list.
template <class Find, class Entries, class Get>
Column bearer_column(std::string_view heading, Entries Model::*list, Find find, Get get)
{
    Column column{.heading = heading, .need = Need::Required, .read = {}};
    column.read = [=](const Model& model, const Part& part) -> CellValue {
        return (model.*list)[get(find(model, part)).index].id;
    };
    column.write = [=](Document& document, const Part& part, const CellText& entry) -> Refusal {
        const auto place = place_of_name(document.model.*list, entry);
        if (const auto* const reason = std::get_if<std::string>(&place)) return *reason;
        auto& bearer = get(find(document.model, part));
        bearer = std::remove_reference_t<decltype(bearer)>(std::get<std::size_t>(place));
        return std::nullopt;
    };
    return column;
}

template <class Find> Column node_column(Find find)
{
    return bearer_column(
        translatable("Node"), &Model::nodes, find, [](auto& load) -> auto& { return load.node; });
}

Column member_column()
{
    return bearer_column(
        translatable("Member"), &Model::members, member_load, [](auto& load) -> auto& { return load.member; });
}

std::string dof_symbol(Dof dof, std::string_view along)
{
    return is_rotation(dof) ? std::string(force_name(dof)) : std::string(along) + force_name(dof).back();
}

// A number of a list of components: added where it is given first, erased where it is taken away.
template <class List> Column component_column(Message heading, Measure measure, Dof dof, List list)
{
    return number_column(std::move(heading), measure,
                         {.get = [=](const Model& model, const Part& part) -> std::optional<Quantity> {
                              const auto& all = list(model, part);
                              const auto found = std::ranges::find(all, dof, &Component::dof);
                              return found != all.end() ? std::optional(found->value) : std::nullopt;
                          },
                          .set = [=](Document& document, const Part& part, const std::optional<Quantity>& value,
                                     const Manner&) -> Refusal {
                              auto& all = list(document.model, part);
                              const auto found = std::ranges::find(all, dof, &Component::dof);
                              if (!value) std::erase_if(all, [=](const Component& c) { return c.dof == dof; });
                              else if (found != all.end()) found->value = *value;
                              else all.push_back({dof, *value});
                              return std::nullopt;
                          }});
}

template <class List> void add_forces(std::vector<Column>& all, DofSet which, std::string_view sentence, List list)
{
    for (const Dof dof : all_dofs) {
        if (!which.contains(dof)) continue;
        const Message heading(sentence, {{"force", std::string(force_name(dof))}});
        all.push_back(component_column(heading, force_measures.of(dof), dof, list));
    }
}

DofSet load_dofs(const Model& model)
{
    DofSet all = member_dofs(model.analysis);
    for (const Dof dof : all_dofs)
        if (dofs(model.analysis).contains(dof)) all.insert(dof);
    return all;
}

template <class Load> Column axes_column()
{
    return word_column(translatable("Axes"), {.words = {translatable("global"), translatable("local")},
                                              .get = [](const Model& model, const Part& part) -> std::size_t {
                                                  return load_as<Load>(model, part).axes == LoadAxes::Local ? 1 : 0;
                                              },
                                              .set =
                                                  [](Document& document, const Part& part, std::size_t word) {
                                                      load_as<Load>(document.model, part).axes = word == 1
                                                                                                     ? LoadAxes::Local
                                                                                                     : LoadAxes::Global;
                                                  }});
}

Column distributed_axes_column()
{
    return word_column(translatable("Axes"),
                       {.words = {translatable("global"), translatable("local"), translatable("projected")},
                        .get = [](const Model& model, const Part& part) -> std::size_t {
                            const auto& load = load_as<DistributedLoad>(model, part);
                            return load.projected ? 2 : load.axes == LoadAxes::Local ? 1 : 0;
                        },
                        .set =
                            [](Document& document, const Part& part, std::size_t word) {
                                auto& load = load_as<DistributedLoad>(document.model, part);
                                load.projected = word == 2;
                                load.axes = word == 1 ? LoadAxes::Local : LoadAxes::Global;
                            }});
}

// "50%" or a length.
std::variant<std::optional<Position>, std::string> position_of(const CellText& entry, const Units& units)
{
    if (entry.text.ends_with('%')) {
        const CellText share{entry.text.substr(0, entry.text.size() - 1), entry.manner, entry.moves};
        auto value = quantity_of(share, Measure::Plain, units);
        if (auto* const reason = std::get_if<std::string>(&value)) return std::move(*reason);
        const auto& number = std::get<std::optional<Quantity>>(value);
        if (!number) return value_needed(entry.manner);
        return std::optional<Position>(Percent{number->value()});
    }
    auto value = quantity_of(entry, Measure::Length, units);
    if (auto* const reason = std::get_if<std::string>(&value)) return std::move(*reason);
    auto& length = std::get<std::optional<Quantity>>(value);
    return length ? std::optional<Position>(std::move(*length)) : std::optional<Position>();
}

CellValue position_value(const std::optional<Position>& position)
{
    if (!position) return {};
    if (const auto* const share = std::get_if<Percent>(&*position)) return *share;
    return std::get<Quantity>(*position);
}

/// get(model, part) and set(model, part, position); set may refuse an absent one.
template <class Get, class Set> Column position_column(std::string_view heading, Get get, Set set)
{
    Column column{.heading = heading, .measure = Measure::Length, .is_number = true, .read = {}};
    column.read = [get](const Model& model, const Part& part) { return position_value(get(model, part)); };
    column.write = [set](Document& document, const Part& part, const CellText& entry) -> Refusal {
        auto position = position_of(entry, document.model.units);
        if (auto* const reason = std::get_if<std::string>(&position)) return std::move(*reason);
        return set(document.model, part, std::get<std::optional<Position>>(position), entry.manner);
    };
    return column;
}

Column bound_column(std::string_view heading, std::optional<Position> DistributedLoad::*bound)
{
    return position_column(
        heading, [bound](const Model& model, const Part& part) { return load_as<DistributedLoad>(model, part).*bound; },
        [bound](Model& model, const Part& part, const std::optional<Position>& position, const Manner&) -> Refusal {
            load_as<DistributedLoad>(model, part).*bound = position;
            return std::nullopt;
        });
}

Column place_column()
{
    return position_column(
        translatable("Distance from the start"),
        [](const Model& model, const Part& part) { return std::optional(load_as<PointLoad>(model, part).at); },
        [](Model& model, const Part& part, const std::optional<Position>& position, const Manner& manner) -> Refusal {
            if (!position) return value_needed(manner);
            load_as<PointLoad>(model, part).at = *position;
            return std::nullopt;
        });
}

using LineValue = DistributedLoad::Value;

std::vector<LineValue>& line_values(Model& model, const Part& part)
{
    return load_as<DistributedLoad>(model, part).values;
}

std::optional<LineValue> line_value(const Model& model, const Part& part, Dof dof)
{
    const auto& all = load_as<DistributedLoad>(model, part).values;
    const auto found = std::ranges::find(all, dof, &LineValue::dof);
    return found != all.end() ? std::optional(*found) : std::nullopt;
}

LineValue& line_value_at(std::vector<LineValue>& all, Dof dof)
{
    const auto found = std::ranges::find(all, dof, &LineValue::dof);
    return found != all.end() ? *found : all.emplace_back(LineValue{dof, Quantity(0.0), std::nullopt});
}

Column line_start_column(Dof dof)
{
    const Message heading(translatable("{q}, start"), {{"q", dof_symbol(dof, "q")}});
    return number_column(heading, line_load_measures.of(dof),
                         {.get = [dof](const Model& model, const Part& part) -> std::optional<Quantity> {
                              const auto value = line_value(model, part, dof);
                              return value ? std::optional(value->start) : std::nullopt;
                          },
                          .set = [dof](Document& document, const Part& part, const std::optional<Quantity>& value,
                                       const Manner&) -> Refusal {
                              std::vector<LineValue>& all = line_values(document.model, part);
                              if (value) line_value_at(all, dof).start = *value;
                              else std::erase_if(all, [dof](const LineValue& v) { return v.dof == dof; });
                              return std::nullopt;
                          }});
}

// Empty where the load is uniform.
Column line_end_column(Dof dof)
{
    const Message heading(translatable("{q}, end"), {{"q", dof_symbol(dof, "q")}});
    return number_column(heading, line_load_measures.of(dof),
                         {.get = [dof](const Model& model, const Part& part) -> std::optional<Quantity> {
                              const auto value = line_value(model, part, dof);
                              return value ? value->end : std::nullopt;
                          },
                          .set = [dof](Document& document, const Part& part, const std::optional<Quantity>& value,
                                       const Manner&) -> Refusal {
                              std::vector<LineValue>& all = line_values(document.model, part);
                              if (value) line_value_at(all, dof).end = value;
                              else if (line_value(document.model, part, dof)) line_value_at(all, dof).end.reset();
                              return std::nullopt;
                          }});
}

std::vector<Column> node_load_columns(const Model& model)
{
    std::vector<Column> all{case_column(), node_column(node_load)};
    add_forces(
        all, dofs(model.analysis), "{force}",
        [](auto& m, const Part& part) -> auto& { return node_load(m, part).components; });
    return all;
}

std::vector<Column> settlement_columns(const Model& model)
{
    std::vector<Column> all{case_column(), node_column(settlement)};
    for (const Dof dof : all_dofs) {
        if (!dofs(model.analysis).contains(dof)) continue;
        all.push_back(component_column(
            name(dof), displacement_measures.of(dof), dof,
            [](auto& m, const Part& part) -> auto& { return settlement(m, part).components; }));
    }
    return all;
}

std::vector<Column> distributed_columns(const Model& model)
{
    std::vector<Column> all{case_column(), member_column(), distributed_axes_column()};
    for (const Dof dof : all_dofs) {
        if (!load_dofs(model).contains(dof)) continue;
        all.push_back(line_start_column(dof));
        all.push_back(line_end_column(dof));
    }
    all.push_back(bound_column(translatable("From"), &DistributedLoad::from));
    all.push_back(bound_column(translatable("To"), &DistributedLoad::to));
    return all;
}

std::vector<Column> point_load_columns(const Model& model)
{
    std::vector<Column> all{case_column(), member_column(), axes_column<PointLoad>(), place_column()};
    add_forces(
        all, load_dofs(model), "{force}",
        [](auto& m, const Part& part) -> auto& { return load_as<PointLoad>(m, part).components; });
    return all;
}

std::vector<Column> end_load_columns(const Model& model)
{
    std::vector<Column> all{case_column(), member_column(), axes_column<EndLoads>()};
    add_forces(
        all, load_dofs(model), translatable("{force}, start"),
        [](auto& m, const Part& part) -> auto& { return load_as<EndLoads>(m, part).start; });
    add_forces(
        all, load_dofs(model), translatable("{force}, end"),
        [](auto& m, const Part& part) -> auto& { return load_as<EndLoads>(m, part).end; });
    return all;
}

std::vector<Column> temperature_columns()
{
    return {case_column(), member_column(),
            field_column(translatable("Rise at the top"), Measure::Temperature,
                         [](auto& m, const Part& part) { return &load_as<TemperatureLoad>(m, part).top; }),
            field_column(translatable("Rise at the bottom"), Measure::Temperature,
                         [](auto& m, const Part& part) { return &load_as<TemperatureLoad>(m, part).bottom; })};
}

std::vector<Column> misfit_columns()
{
    return {case_column(), member_column(),
            field_column(translatable("Elongation"), Measure::Displacement,
                         [](auto& m, const Part& part) { return &load_as<Misfit>(m, part).elongation; })};
}

} // namespace

std::vector<Column> load_columns(const Model& model, TableKind kind)
{
    switch (kind) {
    case TableKind::NodeLoads: return node_load_columns(model);
    case TableKind::Settlements: return settlement_columns(model);
    case TableKind::DistributedLoads: return distributed_columns(model);
    case TableKind::PointLoads: return point_load_columns(model);
    case TableKind::EndLoads: return end_load_columns(model);
    case TableKind::Temperatures: return temperature_columns();
    default: return misfit_columns();
    }
}

} // namespace frame
