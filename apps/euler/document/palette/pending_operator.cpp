#include "apps/euler/document/palette/pending_operator.h"

#include <algorithm>

#include "apps/euler/document/palette/free_name.h"
#include "apps/euler/document/palette/legality.h"
#include "topology/script/script_fault.h"
#include "topology/text/words.h"
#include "ui/text/catalogue.h"

namespace euler {

namespace {

using topology::Entity;
using topology::NamedSolid;
using topology::ScriptFault;
using topology::ScriptRunner;
using ui::Message;
using ui::translatable;

Message in_use(const std::string& name, const NamedSolid& in)
{
    return reason(topology::error(ScriptFault::NameInUse, {name, in.name}));
}

/// Why a typed word cannot be the argument.
std::optional<Message> why_not_word(const ScriptRunner& runner, std::optional<std::size_t> solid, ArgumentKind kind,
                                    const std::string& word)
{
    if (kind == ArgumentKind::Solid && !living_solid(runner, word))
        return reason(topology::error(ScriptFault::NoSolid, {word}));
    if (!solid) return std::nullopt;
    const NamedSolid& in = runner.solids()[*solid];
    if (kind == ArgumentKind::NewVertex && in.names.vertices.find(word, in.solid)) return in_use(word, in);
    if (kind == ArgumentKind::NewFace && in.names.faces.find(word, in.solid)) return in_use(word, in);
    return std::nullopt;
}

template <class Table> std::vector<Entity> listed(const Table& table)
{
    std::vector<Entity> entities;
    for (const auto id : table) entities.emplace_back(id);
    return entities;
}

std::vector<Entity> candidates(const topology::Solid& solid, ArgumentKind kind)
{
    switch (kind) {
    case ArgumentKind::Face: return listed(solid.faces());
    case ArgumentKind::Vertex: return listed(solid.vertices());
    default: return listed(solid.half_edges());
    }
}

std::string word_of(const Choice& choice)
{
    const auto* name = std::get_if<std::string>(&choice);
    if (name != nullptr) return " " + *name;
    const auto* p = std::get_if<topology::Point>(&choice);
    if (p == nullptr) return "";
    return " " + topology::written(p->x) + " " + topology::written(p->y) + " " + topology::written(p->z);
}

} // namespace

std::optional<std::size_t> PendingOperator::solid(const ScriptRunner& runner) const
{
    return chosen_.empty() ? std::nullopt : living_solid(runner, std::get<std::string>(chosen_.front()));
}

std::vector<Entity> PendingOperator::picked() const
{
    std::vector<Entity> entities;
    for (const Choice& choice : chosen_)
        if (const auto* entity = std::get_if<Entity>(&choice)) entities.push_back(*entity);
    return entities;
}

std::optional<Message> PendingOperator::why_not(const ScriptRunner& runner, const Choice& choice) const
{
    const ArgumentKind kind = next().kind;
    if (const auto* word = std::get_if<std::string>(&choice)) return why_not_word(runner, solid(runner), kind, *word);
    const auto* entity = std::get_if<Entity>(&choice);
    if (entity == nullptr) return std::nullopt;
    const NamedSolid& in = runner.solids()[*solid(runner)];
    if (!is_pointed_at(kind))
        return Message(translatable("{what} is not asked for here"), {{"what", in.names.of(*entity, in.solid)}});
    std::vector<Entity> entities = picked();
    entities.push_back(*entity);
    return Legality(in).why_not(form_->verb, kind, entities);
}

std::optional<Message> PendingOperator::choose(const ScriptRunner& runner, const Choice& choice)
{
    if (auto refused = why_not(runner, choice)) return refused;
    chosen_.push_back(choice);
    return std::nullopt;
}

std::vector<Entity> PendingOperator::legal_picks(const ScriptRunner& runner) const
{
    std::vector<Entity> legal;
    if (is_complete() || !is_pointed_at(next().kind)) return legal;
    const NamedSolid& in = runner.solids()[*solid(runner)];
    Legality legality(in);
    std::vector<Entity> entities = picked();
    entities.emplace_back();
    for (const Entity candidate : candidates(in.solid, next().kind)) {
        entities.back() = candidate;
        if (!legality.why_not(form_->verb, next().kind, entities)) legal.push_back(candidate);
    }
    return legal;
}

std::optional<Choice> PendingOperator::suggestion(const ScriptRunner& runner) const
{
    if (is_complete()) return std::nullopt;
    const auto place = solid(runner);
    const topology::Solid none;
    const topology::Names no_names;
    const topology::Names& names = place ? runner.solids()[*place].names : no_names;
    const topology::Solid& in = place ? runner.solids()[*place].solid : none;
    switch (next().kind) {
    case ArgumentKind::NewVertex: return free_vertex_name(names, in);
    case ArgumentKind::NewFace: return free_face_name(names, in);
    case ArgumentKind::AnySolid: return free_solid_name(runner);
    case ArgumentKind::Solid: break;
    default: return std::nullopt;
    }
    const auto is_alive = [](const NamedSolid& solid) { return solid.is_alive(); };
    if (std::count_if(runner.solids().begin(), runner.solids().end(), is_alive) != 1) return std::nullopt;
    return std::find_if(runner.solids().begin(), runner.solids().end(), is_alive)->name;
}

std::string PendingOperator::line(const ScriptRunner& runner) const
{
    std::string text = std::string(form_->word) + word_of(chosen_.front());
    if (const auto place = solid(runner)) text += pointed_text(runner.solids()[*place], form_->verb, picked());
    for (std::size_t i = 1; i < chosen_.size(); ++i) text += word_of(chosen_[i]);
    return text;
}

std::optional<Stepper> preview(const Stepper& lesson, const PendingOperator& draft)
{
    Stepper trial = lesson;
    if (trial.apply(draft.line(lesson.runner()))) return std::nullopt;
    return trial;
}

} // namespace euler
