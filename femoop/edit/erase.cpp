#include "femoop/edit/erase.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "femoop/geometry/path_walk.h"

namespace femoop {

namespace {

/// The places of a list after some of its entries are gone.
template <class Tag> class Survivors {
public:
    explicit Survivors(std::size_t n) : new_index_(n, 0) {}

    void erase(Id<Tag> id) { new_index_.at(id.index) = gone; }
    void erase(const std::vector<Id<Tag>>& ids)
    {
        for (const Id<Tag> id : ids) erase(id);
    }
    bool has(Id<Tag> id) const { return new_index_[id.index] != gone; }
    bool has(const std::optional<Id<Tag>>& id) const { return !id || has(*id); } ///< no reference dangles either

    /// Numbers those that stay.
    void count()
    {
        std::uint32_t n = 0;
        for (std::uint32_t& index : new_index_)
            if (index != gone) index = n++;
    }
    void renumber(Id<Tag>& id) const { id.index = new_index_[id.index]; }
    void renumber(std::optional<Id<Tag>>& id) const
    {
        if (id) renumber(*id);
    }

    /// Keeps the entries of the list that stay. `first` is the id of its first entry.
    template <class List> void keep(List& list, std::size_t first = 0) const
    {
        List kept;
        for (std::size_t i = 0; i < list.size(); ++i)
            if (has(Id<Tag>(first + i))) kept.push_back(std::move(list[i]));
        list = std::move(kept);
    }

private:
    static constexpr std::uint32_t gone = static_cast<std::uint32_t>(-1);
    std::vector<std::uint32_t> new_index_;
};

class Eraser {
public:
    Eraser(Model& model, const Parts& parts)
        : model_(model),
          nodes_(model.nodes.size()),
          members_(model.members.size()),
          materials_(model.materials.size()),
          sections_(model.sections.size()),
          cases_(model.n_cases()),
          paths_(model.moving_loads.paths.size()),
          trains_(model.moving_loads.trains.size())
    {
        nodes_.erase(parts.nodes);
        members_.erase(parts.members);
        materials_.erase(parts.materials);
        sections_.erase(parts.sections);
        cases_.erase(parts.cases);
        for (std::size_t i = 0; i < model.members.size(); ++i)
            if (!std::ranges::all_of(model.members[i].nodes, [&](NodeId node) { return nodes_.has(node); }))
                members_.erase(MemberId(i));
    }

    void require_unused() const
    {
        for (std::size_t i = 0; i < model_.members.size(); ++i) {
            const Member& member = model_.members[i];
            if (members_.has(MemberId(i)) && !(materials_.has(member.material) && sections_.has(member.section)))
                throw std::invalid_argument("erase: member " + member.id + " uses the material or the section");
        }
    }

    void run()
    {
        drop_dependents();
        nodes_.keep(model_.nodes);
        members_.keep(model_.members);
        materials_.keep(model_.materials);
        sections_.keep(model_.sections);
        const std::size_t n_load_cases = model_.load_cases.size();
        cases_.keep(model_.load_cases);
        cases_.keep(model_.combinations, n_load_cases);
        paths_.keep(model_.moving_loads.paths);
        trains_.keep(model_.moving_loads.trains);
        renumber();
    }

private:
    void drop_dependents()
    {
        for (LoadCase& load_case : model_.load_cases) {
            std::erase_if(load_case.nodes, [&](const NodeLoad& load) { return !nodes_.has(load.node); });
            std::erase_if(load_case.settlements, [&](const Settlement& s) { return !nodes_.has(s.node); });
            std::erase_if(load_case.members, [&](const MemberLoad& load) { return !members_.has(load.member); });
        }
        for (Combination& combination : model_.combinations)
            std::erase_if(combination.terms, [&](const Combination::Term& term) { return !cases_.has(term.of); });
        std::erase_if(model_.expected, [&](const Expected& check) {
            return !nodes_.has(check.node) || !members_.has(check.member) || !cases_.has(check.load_case);
        });
        drop_moving_loads();
    }

    /// A path that loses a member at one of its ends is shorter; one that breaks is gone, with what moves along it.
    void drop_moving_loads()
    {
        MovingLoads& moving = model_.moving_loads;
        for (std::size_t i = 0; i < moving.paths.size(); ++i)
            if (!shorten(moving.paths[i].members)) paths_.erase(PathId(i));
        std::erase_if(moving.influence_lines, [&](InfluenceLineDefinition& line) {
            return !nodes_.has(line.effect.node) || !members_.has(line.effect.member) || !keeps_path(line.path);
        });
        for (std::size_t i = 0; i < moving.trains.size(); ++i)
            if (!keeps_path(moving.trains[i].path)) trains_.erase(TrainId(i));
        std::erase_if(moving.envelopes, [&](MovingEnvelope& envelope) {
            std::erase_if(envelope.trains, [&](TrainId train) { return !trains_.has(train); });
            return envelope.trains.empty() || !cases_.has(envelope.with);
        });
    }

    bool shorten(std::vector<MemberId>& path) const
    {
        std::erase_if(path, [&](MemberId member) { return !members_.has(member); });
        return !why_no_path(model_, path, "");
    }

    bool keeps_path(LoadPathReference& path) const
    {
        if (const auto* id = std::get_if<PathId>(&path)) return paths_.has(*id);
        return shorten(std::get<std::vector<MemberId>>(path));
    }

    void renumber()
    {
        nodes_.count();
        members_.count();
        materials_.count();
        sections_.count();
        cases_.count();
        for (Member& member : model_.members) {
            for (NodeId& node : member.nodes) nodes_.renumber(node);
            materials_.renumber(member.material);
            sections_.renumber(member.section);
        }
        for (LoadCase& load_case : model_.load_cases) {
            for (NodeLoad& load : load_case.nodes) nodes_.renumber(load.node);
            for (Settlement& settlement : load_case.settlements) nodes_.renumber(settlement.node);
            for (MemberLoad& load : load_case.members) members_.renumber(load.member);
        }
        for (Combination& combination : model_.combinations)
            for (Combination::Term& term : combination.terms) cases_.renumber(term.of);
        for (Expected& check : model_.expected) {
            nodes_.renumber(check.node);
            members_.renumber(check.member);
            cases_.renumber(check.load_case);
        }
        renumber_moving_loads();
    }

    void renumber_moving_loads()
    {
        paths_.count();
        trains_.count();
        for (LoadPath& path : model_.moving_loads.paths) renumber(path.members);
        for (InfluenceLineDefinition& line : model_.moving_loads.influence_lines) {
            nodes_.renumber(line.effect.node);
            members_.renumber(line.effect.member);
            renumber(line.path);
        }
        for (Train& train : model_.moving_loads.trains) renumber(train.path);
        for (MovingEnvelope& envelope : model_.moving_loads.envelopes) {
            for (TrainId& train : envelope.trains) trains_.renumber(train);
            cases_.renumber(envelope.with);
        }
    }

    void renumber(std::vector<MemberId>& members) const
    {
        for (MemberId& member : members) members_.renumber(member);
    }

    void renumber(LoadPathReference& path) const
    {
        if (auto* id = std::get_if<PathId>(&path)) paths_.renumber(*id);
        else renumber(std::get<std::vector<MemberId>>(path));
    }

    Model& model_;
    Survivors<NodeTag> nodes_;
    Survivors<MemberTag> members_;
    Survivors<MaterialTag> materials_;
    Survivors<SectionTag> sections_;
    Survivors<CaseTag> cases_;
    Survivors<PathTag> paths_;
    Survivors<TrainTag> trains_;
};

} // namespace

void erase(Model& model, const Parts& parts)
{
    Eraser eraser(model, parts);
    eraser.require_unused();
    eraser.run();
}

bool is_used(const Model& model, MaterialId material)
{
    return std::ranges::any_of(model.members, [&](const Member& member) { return member.material == material; });
}

bool is_used(const Model& model, SectionId section)
{
    return std::ranges::any_of(model.members, [&](const Member& member) { return member.section == section; });
}

} // namespace femoop
