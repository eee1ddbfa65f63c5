#include "femoop/edit/moving_load_change.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "femoop/geometry/path_walk.h"

namespace femoop {

void change_paths(Model& model, const std::function<void(std::vector<MemberId>&)>& change)
{
    const auto change_reference = [&](LoadPathReference& path) {
        if (auto* members = std::get_if<std::vector<MemberId>>(&path)) change(*members);
    };
    for (LoadPath& path : model.moving_loads.paths) change(path.members);
    for (InfluenceLineDefinition& line : model.moving_loads.influence_lines) change_reference(line.path);
    for (Train& train : model.moving_loads.trains) change_reference(train.path);
}

void lead_with(MovingLoads& moving, LoadPath path)
{
    const auto renumber = [](LoadPathReference& reference) {
        if (auto* id = std::get_if<PathId>(&reference)) *id = PathId(id->index + std::size_t{1});
    };
    for (InfluenceLineDefinition& line : moving.influence_lines) renumber(line.path);
    for (Train& train : moving.trains) renumber(train.path);
    moving.paths.insert(moving.paths.begin(), std::move(path));
}

// The other way round where the path comes from the whole member's end.
void follow_split(Model& model, MemberId first, MemberId second)
{
    change_paths(model, [&](std::vector<MemberId>& path) {
        std::vector<MemberId> forwards, backwards;
        for (const MemberId member : path) {
            forwards.push_back(member);
            if (member == first) forwards.push_back(second);
            if (member == first) backwards.push_back(second);
            backwards.push_back(member);
        }
        path = walk(model, backwards).n_passed > walk(model, forwards).n_passed ? backwards : forwards;
    });
}

void follow_merge(Model& model, MemberId first, MemberId second)
{
    change_paths(model, [&](std::vector<MemberId>& path) {
        std::ranges::replace(path, second, first);
        const auto is_twice = [&](MemberId a, MemberId b) { return a == first && b == first; };
        path.erase(std::unique(path.begin(), path.end(), is_twice), path.end());
    });
}

namespace {

/// Looks parts up by their names in another model.
class Carrier {
public:
    Carrier(const Model& from, const Model& to) : from_(from), to_(to) {}

    MovingLoads carried()
    {
        for (const LoadPath& path : from_.moving_loads.paths) add(path);
        for (const InfluenceLineDefinition& line : from_.moving_loads.influence_lines) add(line);
        for (const Train& train : from_.moving_loads.trains) add(train);
        for (const MovingEnvelope& envelope : from_.moving_loads.envelopes) add(envelope);
        return std::move(moving_);
    }

private:
    std::optional<std::vector<MemberId>> members(const std::vector<MemberId>& path) const
    {
        std::vector<MemberId> found;
        for (const MemberId id : path)
            if (const auto member = to_.find_member(from_[id].id)) found.push_back(*member);
        if (found.size() != path.size() || why_no_path(to_, found, "")) return std::nullopt;
        return found;
    }

    std::optional<LoadPathReference> reference(const LoadPathReference& path) const
    {
        if (const auto* id = std::get_if<PathId>(&path))
            return paths_[id->index] ? std::optional<LoadPathReference>(*paths_[id->index]) : std::nullopt;
        if (auto found = members(std::get<std::vector<MemberId>>(path))) return std::move(*found);
        return std::nullopt;
    }

    void add(const LoadPath& path)
    {
        auto found = members(path.members);
        paths_.push_back(found ? std::optional(PathId(moving_.paths.size())) : std::nullopt);
        if (found) moving_.paths.push_back({.id = path.id, .members = std::move(*found)});
    }

    void add(InfluenceLineDefinition line)
    {
        const auto path = reference(line.path);
        MovingEffect& effect = line.effect;
        if (effect.node && !(effect.node = to_.find_node(from_[*effect.node].id))) return;
        if (effect.member && !(effect.member = to_.find_member(from_[*effect.member].id))) return;
        if (!path) return;
        line.path = *path;
        moving_.influence_lines.push_back(std::move(line));
    }

    void add(Train train)
    {
        const auto path = reference(train.path);
        trains_.push_back(path ? std::optional(TrainId(moving_.trains.size())) : std::nullopt);
        if (!path) return;
        train.path = *path;
        moving_.trains.push_back(std::move(train));
    }

    void add(MovingEnvelope envelope)
    {
        std::erase_if(envelope.trains, [&](TrainId train) { return !trains_[train.index]; });
        for (TrainId& train : envelope.trains) train = *trains_[train.index];
        if (envelope.with && !(envelope.with = to_.find_case(from_.case_name(*envelope.with)))) return;
        if (!envelope.trains.empty()) moving_.envelopes.push_back(std::move(envelope));
    }

    const Model &from_, &to_;
    MovingLoads moving_;
    std::vector<std::optional<PathId>> paths_;
    std::vector<std::optional<TrainId>> trains_;
};

} // namespace

MovingLoads carried_over(const Model& from, const Model& to) { return Carrier(from, to).carried(); }

} // namespace femoop
