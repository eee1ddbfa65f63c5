#include "femoop/edit/insert.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "femoop/edit/condense.h"
#include "femoop/edit/naming.h"
#include "femoop/model/quantity/in_units.h"

namespace femoop {

namespace {

Model without_extra(Model model)
{
    model.extra.clear();
    return model;
}

/// Adds one model's parts to another's lists.
class Insertion {
public:
    Insertion(Model& model, const Model& other)
        : model_(model), other_(in_units(without_extra(other), model.units)), n_load_cases_(model.load_cases.size())
    {}

    Parts run()
    {
        share(model_.materials, other_.materials, materials_, added_.materials);
        share(model_.sections, other_.sections, sections_, added_.sections);
        for (const Node& node : other_.nodes) add(node);
        for (const Member& member : other_.members) add(member);
        for (LoadCase& load_case : other_.load_cases) add(std::move(load_case));
        make_room_for_load_cases();
        add_combinations();
        return added_;
    }

private:
    /// Finds each entry among those that are there, or adds it.
    template <class Entry, class Id>
    void share(std::vector<Entry>& list, std::vector<Entry>& entries, std::vector<Id>& places, std::vector<Id>& added)
    {
        for (Entry& entry : entries) {
            const auto alike = std::ranges::find_if(list, [&](const Entry& e) { return are_alike(e, entry); });
            places.emplace_back(static_cast<std::size_t>(alike - list.begin()));
            if (alike != list.end()) continue;
            entry.id = fresh_id(list, entry.id);
            added.push_back(model_.add(std::move(entry)));
        }
    }

    void add(Node node)
    {
        if (model_.find_node(node.id)) node.id = fresh_node_id(model_);
        nodes_.push_back(model_.add(std::move(node)));
        added_.nodes.push_back(nodes_.back());
    }

    void add(Member member)
    {
        const bool is_after_nodes = is_named_after_nodes(other_, member);
        for (NodeId& node : member.nodes) node = nodes_[node.index];
        if (member.material) member.material = materials_[member.material->index];
        if (member.section) member.section = sections_[member.section->index];
        if (is_after_nodes) member.id = model_[member.nodes[0]].id + model_[member.nodes[1]].id;
        if (model_.find_member(member.id)) member.id = fresh_member_id(model_, member.nodes[0], member.nodes[1]);
        members_.push_back(model_.add(std::move(member)));
        added_.members.push_back(members_.back());
    }

    void add(LoadCase load_case)
    {
        for (NodeLoad& load : load_case.nodes) load.node = nodes_[load.node.index];
        for (Settlement& settlement : load_case.settlements) settlement.node = nodes_[settlement.node.index];
        for (MemberLoad& load : load_case.members) load.member = members_[load.member.index];
        const auto there = std::ranges::find_if(model_.load_cases, [&](const LoadCase& mine) {
            return mine.id == load_case.id && mine.self_weight == load_case.self_weight;
        });
        cases_.emplace_back(static_cast<std::size_t>(there - model_.load_cases.begin()));
        if (there != model_.load_cases.end()) {
            append(there->nodes, load_case.nodes);
            append(there->settlements, load_case.settlements);
            append(there->members, load_case.members);
            return;
        }
        load_case.id = fresh_case_id(model_, load_case.id);
        added_.cases.push_back(cases_.back());
        model_.load_cases.push_back(std::move(load_case));
    }

    template <class Load> static void append(std::vector<Load>& list, const std::vector<Load>& more)
    {
        list.insert(list.end(), more.begin(), more.end());
    }

    /// The ids of combinations follow those of the load cases, of which there are more now.
    void make_room_for_load_cases()
    {
        const std::size_t n_new = model_.load_cases.size() - n_load_cases_;
        const auto shift = [&](CaseId& id) {
            if (id.index >= n_load_cases_) id = CaseId(id.index + n_new);
        };
        for (Combination& combination : model_.combinations)
            for (Combination::Term& term : combination.terms) shift(term.of);
        for (Expected& check : model_.expected)
            if (check.load_case) shift(*check.load_case);
        for (MovingEnvelope& envelope : model_.moving_loads.envelopes)
            if (envelope.with) shift(*envelope.with);
    }

    /// The places of all come first, since a combination may name a later one.
    void add_combinations()
    {
        std::size_t n = model_.n_cases();
        std::vector<Combination> fresh;
        for (const Combination& combination : other_.combinations) {
            const auto there = same_combination(combination);
            cases_.push_back(there.value_or(CaseId(n)));
            if (there) continue;
            added_.cases.emplace_back(n++);
            fresh.push_back(combination);
        }
        for (Combination& combination : fresh) {
            for (Combination::Term& term : combination.terms) term.of = cases_[term.of.index];
            combination.id = fresh_case_id(model_, combination.id);
            model_.combinations.push_back(std::move(combination));
        }
    }

    /// One of the model's with the same name and the same load cases.
    std::optional<CaseId> same_combination(Combination combination) const
    {
        for (Combination::Term& term : combination.terms) {
            if (term.of.index >= other_.load_cases.size()) return std::nullopt;
            term.of = cases_[term.of.index];
        }
        const auto there = std::ranges::find(model_.combinations, combination);
        if (there == model_.combinations.end()) return std::nullopt;
        return CaseId(model_.load_cases.size() + static_cast<std::size_t>(there - model_.combinations.begin()));
    }

    Model& model_;
    Model other_;
    std::size_t n_load_cases_; ///< that were there
    Parts added_;
    std::vector<MaterialId> materials_; ///< of the other, in the model
    std::vector<SectionId> sections_;
    std::vector<NodeId> nodes_;
    std::vector<MemberId> members_;
    std::vector<CaseId> cases_;
};

} // namespace

Parts insert(Model& model, const Model& other, const Placement& placement)
{
    if (other.analysis != model.analysis)
        throw std::invalid_argument("insert: a " + std::string(name(other.analysis)) + " model cannot go into a " +
                                    std::string(name(model.analysis)) + " model");
    const Parts added = Insertion(model, other).run();
    place_nodes(model, added.nodes, placement);
    return added;
}

CaseId insert_load_case(Model& model, std::string id)
{
    Model alone;
    alone.units = model.units;
    alone.analysis = model.analysis;
    alone.load_cases.push_back({.id = std::move(id)});
    return insert(model, alone, Placement::Identity()).cases.front();
}

} // namespace femoop
