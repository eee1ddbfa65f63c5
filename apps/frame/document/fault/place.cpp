#include "apps/frame/document/fault/place.h"

#include <algorithm>
#include <charconv>

namespace frame {

using femoop::CaseId;
using femoop::Fault;
using femoop::FaultKind;
using femoop::Model;

namespace {

/// Reads the words of the file from left to right.
class PlaceReader {
public:
    explicit PlaceReader(std::string_view text) : rest_(text) {}

    std::optional<FaultPlace> read()
    {
        FaultPlace place;
        do {
            auto step = this->step();
            if (!step) return std::nullopt;
            place.steps.push_back(std::move(*step));
        } while (take("."));
        return rest_.empty() ? std::optional(std::move(place)) : std::nullopt;
    }

private:
    bool take(std::string_view sign)
    {
        if (!rest_.starts_with(sign)) return false;
        rest_.remove_prefix(sign.size());
        return true;
    }

    std::optional<FaultPlace::Step> step()
    {
        FaultPlace::Step step;
        const std::size_t key_ends = std::min({rest_.find('.'), rest_.find('['), rest_.find(" \""), rest_.size()});
        step.key = rest_.substr(0, key_ends);
        rest_.remove_prefix(key_ends);
        if (take("[")) {
            step.index = number();
            if (!step.index || !take("]")) return std::nullopt;
        }
        if (take(" \"")) step.name = name();
        const bool is_empty = step.key.empty() && !step.index;
        return is_empty ? std::nullopt : std::optional(std::move(step));
    }

    std::optional<std::size_t> number()
    {
        std::size_t value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc()) return std::nullopt;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    // A quotation mark may be part of the name: the one that ends it stands before a point or at the end.
    std::string name()
    {
        std::size_t end = rest_.find("\".");
        if (end == std::string_view::npos) end = rest_.empty() ? 0 : rest_.size() - 1;
        std::string name(rest_.substr(0, end));
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        return name;
    }

    std::string_view rest_;
};

template <class Entries> std::string name_in(const Entries& list, std::size_t i)
{
    return i < list.size() ? list[i].id : std::string();
}

template <class Visit> void visit_list(const Model& model, std::string_view list, const Visit& visit)
{
    if (list == "materials") visit(model.materials);
    if (list == "sections") visit(model.sections);
    if (list == "nodes") visit(model.nodes);
    if (list == "members") visit(model.members);
    if (list == "load_cases") visit(model.load_cases);
    if (list == "combinations") visit(model.combinations);
}

std::string name_of(const Model& model, std::string_view list, std::size_t i)
{
    std::string name;
    visit_list(model, list, [&](const auto& entries) { name = name_in(entries, i); });
    return name;
}

std::optional<std::size_t> entry_named(const Model& model, std::string_view list, const std::string& name)
{
    std::optional<std::size_t> place;
    visit_list(model, list, [&](const auto& entries) {
        const auto found = std::ranges::find_if(entries, [&](const auto& entry) { return entry.id == name; });
        if (found != entries.end()) place = static_cast<std::size_t>(found - entries.begin());
    });
    return place;
}

/// The name of the node or member that a load acts on.
std::string bearer_of(const Model& model, const femoop::LoadCase& load_case, std::string_view list, std::size_t i)
{
    if (list == "nodes" && i < load_case.nodes.size()) return name_in(model.nodes, load_case.nodes[i].node.index);
    if (list == "settlements" && i < load_case.settlements.size())
        return name_in(model.nodes, load_case.settlements[i].node.index);
    if (list == "members" && i < load_case.members.size())
        return name_in(model.members, load_case.members[i].member.index);
    return "";
}

void add_names(FaultPlace& place, const Model& model)
{
    FaultPlace::Step& first = place.steps.front();
    if (!first.index) return;
    if (first.name.empty()) first.name = name_of(model, first.key, *first.index);
    if (!place.is_load() || *first.index >= model.load_cases.size()) return;
    FaultPlace::Step& load = place.steps[1];
    if (load.name.empty()) load.name = bearer_of(model, model.load_cases[*first.index], load.key, *load.index);
}

bool is_about_its_name(FaultKind kind)
{
    return kind == FaultKind::EmptyId || kind == FaultKind::ControlCharacterInId || kind == FaultKind::RepeatedId;
}

std::optional<Part> load_at(std::size_t load_case, const FaultPlace::Step& load)
{
    if (load.key == "nodes") return NodeLoadPlace{load_case, *load.index};
    if (load.key == "settlements") return SettlementPlace{load_case, *load.index};
    return MemberLoadPlace{load_case, *load.index};
}

std::optional<Part> any_part_at(const FaultPlace& place)
{
    const FaultPlace::Step& first = place.steps.front();
    if (!first.index) return std::nullopt;
    const std::size_t i = *first.index;
    if (first.key == "materials") return femoop::MaterialId(i);
    if (first.key == "sections") return femoop::SectionId(i);
    if (first.key == "nodes") return femoop::NodeId(i);
    if (first.key == "members") return femoop::MemberId(i);
    if (first.key == "combinations") return CombinationPlace{i};
    if (first.key != "load_cases") return std::nullopt;
    return place.is_load() ? load_at(i, place.steps[1]) : LoadCasePlace{i};
}

std::optional<std::size_t> load_on(const Model& model, const femoop::LoadCase& load_case, const FaultPlace::Step& load)
{
    const std::size_t n = load.key == "nodes"         ? load_case.nodes.size()
                          : load.key == "settlements" ? load_case.settlements.size()
                                                      : load_case.members.size();
    for (std::size_t i = 0; i < n; ++i)
        if (bearer_of(model, load_case, load.key, i) == load.name) return i;
    return std::nullopt;
}

/// Where the names stand now: since the fault was found parts may have gone, and of an excerpt numbers are others.
std::optional<FaultPlace> relocated(FaultPlace place, const Model& model)
{
    FaultPlace::Step& first = place.steps.front();
    if (!first.index) return std::nullopt;
    if (!first.name.empty() && name_of(model, first.key, *first.index) != first.name)
        first.index = entry_named(model, first.key, first.name);
    if (!first.index) return std::nullopt;
    if (!place.is_load() || *first.index >= model.load_cases.size()) return place;
    FaultPlace::Step& load = place.steps[1];
    const femoop::LoadCase& load_case = model.load_cases[*first.index];
    if (load.name.empty() || bearer_of(model, load_case, load.key, *load.index) == load.name) return place;
    load.index = load_on(model, load_case, load);
    return load.index ? std::optional(place) : std::nullopt;
}

} // namespace

bool FaultPlace::is_load() const
{
    if (steps.size() < 2 || steps[0].key != "load_cases" || !steps[0].index || !steps[1].index) return false;
    return steps[1].key == "nodes" || steps[1].key == "settlements" || steps[1].key == "members";
}

std::string FaultPlace::text() const
{
    std::string text;
    for (const Step& step : steps) {
        text += (text.empty() ? "" : ".") + step.key;
        if (step.index) text += '[' + std::to_string(*step.index) + ']';
        if (!step.name.empty()) text += " \"" + step.name + '"';
    }
    return text;
}

std::optional<FaultPlace> place_of(const Fault& fault)
{
    const bool has_place = femoop::pattern(fault.kind).starts_with("{0}: ") && !fault.arguments.empty();
    return has_place ? PlaceReader(fault.arguments.front()).read() : std::nullopt;
}

std::vector<Fault> named(std::vector<Fault> faults, const Model& model)
{
    for (Fault& fault : faults) {
        std::optional<FaultPlace> place = place_of(fault);
        if (!place) continue;
        add_names(*place, model);
        fault.arguments.front() = place->text();
    }
    return faults;
}

std::optional<CaseId> case_of(const Fault& fault, const Model& model)
{
    const std::optional<FaultPlace> place = place_of(fault);
    if (!place || !place->steps.front().index || is_about_its_name(fault.kind)) return std::nullopt;
    const auto& [key, index, name] = place->steps.front();
    if (key == "load_cases" && *index < model.load_cases.size()) return CaseId(*index);
    if (key == "combinations" && *index < model.combinations.size()) return CaseId(model.load_cases.size() + *index);
    return std::nullopt;
}

std::optional<Part> part_at(const FaultPlace& place, const Model& model)
{
    const std::optional<FaultPlace> now = relocated(place, model);
    const std::optional<Part> part = now ? any_part_at(*now) : std::nullopt;
    return part && has(model, *part) ? part : std::nullopt;
}

} // namespace frame
