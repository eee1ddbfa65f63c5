#include "femoop/edit/excerpt.h"

#include "femoop/edit/condense.h"
#include "femoop/edit/erase.h"

namespace femoop {

namespace {

/// What members meet at every node.
struct Meeting {
    bool is_kept = false, is_cut = false;
};

std::vector<Meeting> meetings(const Model& model, const std::vector<bool>& is_kept)
{
    std::vector<Meeting> at(model.nodes.size());
    for (std::size_t m = 0; m < model.members.size(); ++m)
        for (const NodeId node : model.members[m].nodes) {
            if (is_kept[m]) at[node.index].is_kept = true;
            else at[node.index].is_cut = true;
        }
    return at;
}

} // namespace

Excerpt excerpt_of(const Model& model, const std::vector<MemberId>& members)
{
    std::vector<bool> is_kept(model.members.size(), false);
    for (const MemberId member : members) is_kept[member.index] = true;
    Excerpt excerpt{.model = model, .held = {}};
    excerpt.model.expected.clear();
    excerpt.model.extra.clear();
    excerpt.model.moving_loads = {};
    Parts others;
    for (std::size_t m = 0; m < is_kept.size(); ++m)
        if (!is_kept[m]) others.members.emplace_back(m);
    const std::vector<Meeting> at = meetings(model, is_kept);
    for (std::size_t n = 0; n < at.size(); ++n) {
        if (!at[n].is_kept) {
            others.nodes.emplace_back(n);
        } else if (at[n].is_cut) {
            excerpt.model.nodes[n].support = Support{.kind = SupportKind::Fixed};
            excerpt.held.emplace_back(n - others.nodes.size());
        }
    }
    erase(excerpt.model, others);
    condense(excerpt.model);
    return excerpt;
}

Model structure_alone(Model model)
{
    model.title.clear();
    model.notes.clear();
    model.expected.clear();
    model.extra.clear();
    model.moving_loads = {};
    return model;
}

} // namespace femoop
