#include "apps/frame/session/set_commands.h"

#include <algorithm>

namespace frame {

using ui::Message;
using ui::translatable;

namespace {

Message named(std::string_view what, const Session& session, NamedSetPlace set)
{
    return {what, {{"name", session.document().companion.sets.at(set.set).name}}};
}

bool is_support(const Part& part) { return std::holds_alternative<femoop::NodeId>(part); }

} // namespace

void add_set_commands(CommandTable& table)
{
    Menu(table, translatable("Edit"))
        .step(
            {"edit.keep_under_name", translatable("Keep the support or load under a name")},
            [](Workspace& workspace) { keep_under_name(workspace.session, workspace.session.selection.parts()); },
            [](const Workspace& workspace) {
                return why_not_keep(workspace.session, workspace.session.selection.parts());
            });
}

std::optional<Message> why_not_keep(const Session& session, std::span<const Part> parts)
{
    const auto first = parts.empty() ? std::nullopt : value_of(session.model(), parts.front());
    if (!first) return Message(translatable("select a supported node or a load"));
    const bool is_common = std::ranges::all_of(parts, [&](const Part& part) {
        const auto value = value_of(session.model(), part);
        return value && are_alike(*value, *first);
    });
    if (is_common) return std::nullopt;
    return Message(translatable("what is selected differs"));
}

void keep_under_name(Session& session, std::span<const Part> parts)
{
    const Part part = parts.front();
    const std::string name = session.view.tr(is_support(part) ? translatable("support") : translatable("load"));
    session.change({{translatable("Keep under a name: {part}"), {{"part", title(session.model(), part)}}},
                    [&](Document& document) { keep(document, part, name); }});
}

void give(Session& session, NamedSetPlace set, std::span<const Part> parts)
{
    session.change_soundly({named(translatable("Give: {name}"), session, set),
                            [&](Document& document) { give(document, set, parts, session.view.load_case); }});
}

void assign(Session& session, NamedSetPlace set, std::span<const Part> parts)
{
    session.change_soundly({named(translatable("Give: {name}"), session, set), [&](Document& document) {
                                for (const Part& part : parts) assign(document, set, part);
                            }});
}

void replace(Session& session, NamedSetPlace set, std::span<const Part> parts)
{
    session.change({named(translatable("Replace: {name}"), session, set),
                    [&](Document& document) { replace(document, set, parts.front()); }});
}

void select_users(Session& session, NamedSetPlace set)
{
    session.selection.clear();
    for (const Part& part : users(session.document(), set)) session.selection.add(part);
}

std::optional<Message> rename(Session& session, NamedSetPlace set, const std::string& name)
{
    if (session.document().companion.sets.at(set.set).name == name) return std::nullopt;
    if (auto reason = why_not_rename(session.document(), set, name)) return reason;
    session.change({named(translatable("Rename: {name}"), session, set),
                    [&](Document& document) { rename(document, set, name); }});
    return std::nullopt;
}

void erase(Session& session, NamedSetPlace set)
{
    session.change({named(translatable("Delete the name: {name}"), session, set),
                    [&](Document& document) { erase(document, set); }});
}

} // namespace frame
