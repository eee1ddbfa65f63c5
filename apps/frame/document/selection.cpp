#include "apps/frame/document/selection.h"

#include <algorithm>
#include <utility>

#include "apps/frame/document/document.h"

namespace frame {

using namespace femoop;

bool Selection::contains(const Part& part) const { return std::ranges::find(parts_, part) != parts_.end(); }

std::optional<Part> Selection::only() const { return size() == 1 ? std::optional(parts_.front()) : std::nullopt; }

void Selection::add(const Part& part)
{
    if (!contains(part)) parts_.push_back(part);
}

void Selection::toggle(const Part& part)
{
    if (std::erase(parts_, part) == 0) parts_.push_back(part);
}

namespace {

/// Finds the part of one model in another.
class Follower {
public:
    Follower(const Document& before, const Document& after) : before_(before), after_(after) {}

    std::optional<Part> operator()(NodeId id) const { return named(after_.model.nodes, before_.model[id], id); }
    std::optional<Part> operator()(MemberId id) const { return named(after_.model.members, before_.model[id], id); }
    std::optional<Part> operator()(MaterialId id) const { return named(after_.model.materials, before_.model[id], id); }
    std::optional<Part> operator()(SectionId id) const { return named(after_.model.sections, before_.model[id], id); }
    std::optional<Part> operator()(DimensionPlace place) const
    {
        const auto& list = after_.companion.dimensions;
        const auto& nodes = before_.companion.dimensions[place.dimension].nodes;
        if (has(after_, place) && list[place.dimension].nodes == nodes) return place;
        const auto found = std::ranges::find(list, nodes, &DimensionLine::nodes);
        if (found == list.end()) return std::nullopt;
        return DimensionPlace{static_cast<std::size_t>(found - list.begin())};
    }
    template <class Place> std::optional<Part> operator()(const Place& place) const
    {
        return has(after_, place) ? std::optional<Part>(place) : std::nullopt;
    }

private:
    // Most often it is where it was: a drag moves nothing in the lists.
    template <class Entry, class Id>
    static std::optional<Part> named(const std::vector<Entry>& list, const Entry& entry, Id was)
    {
        if (was.index < list.size() && list[was.index].id == entry.id) return was;
        const auto found = std::ranges::find(list, entry.id, &Entry::id);
        if (found == list.end()) return std::nullopt;
        return Id(static_cast<std::size_t>(found - list.begin()));
    }

    const Document& before_;
    const Document& after_;
};

} // namespace

void Selection::follow(const Document& before, const Document& after)
{
    const Follower follower(before, after);
    std::vector<Part> found;
    for (const Part& part : parts_) {
        if (!has(before, part)) continue;
        if (const std::optional<Part> now = std::visit(follower, part)) found.push_back(*now);
    }
    parts_ = std::move(found);
}

Selection everything(const Model& model)
{
    Selection all;
    for (const Part& part : parts(model)) {
        if (std::holds_alternative<NodeId>(part) || std::holds_alternative<MemberId>(part)) all.add(part);
    }
    return all;
}

namespace {

bool are_alike(const Node& a, const Node& b) { return a.support == b.support && a.hinge == b.hinge; }

bool are_alike(const Member& a, const Member& b)
{
    return a.material == b.material && a.section == b.section && a.bar == b.bar && a.theory == b.theory;
}

template <class Id, class Entry> void add_like(Selection& found, const std::vector<Entry>& entries, const Part& pattern)
{
    const auto* const id = std::get_if<Id>(&pattern);
    if (id == nullptr) return;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (are_alike(entries[i], entries[id->index])) found.add(Id(i));
    }
}

} // namespace

Selection similar(const Model& model, const Selection& selection)
{
    Selection found;
    for (const Part& part : selection.parts()) {
        add_like<NodeId>(found, model.nodes, part);
        add_like<MemberId>(found, model.members, part);
    }
    return found;
}

} // namespace frame
