#include "apps/frame/session/property_commands.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "apps/frame/document/command.h"
#include "apps/frame/document/companion/companion_file.h"
#include "apps/frame/document/fault/place.h"
#include "apps/frame/document/load_cases.h"
#include "apps/frame/document/section_command.h"
#include "apps/frame/document/selected_members.h"
#include "apps/frame/session/case_commands.h"
#include "femoop/edit/condense.h"
#include "femoop/io/model_file.h"
#include "femoop/model/fault/errors_among.h"
#include "femoop/typical/steel.h"

namespace frame {

using femoop::MaterialId;
using femoop::MemberId;
using femoop::Model;
using femoop::SectionId;
using ui::translatable;

namespace {

std::string text_of(std::size_t n) { return std::to_string(n); }

/// Like that of the selected members, else steel.
femoop::Material pattern(const Session& session, const std::vector<MemberId>& members)
{
    const Model& model = session.model();
    const auto first = members.empty() ? std::nullopt : model[members.front()].material;
    if (first) return model[*first];
    return femoop::steel(model.units, "210 GPa");
}

void edit_title(Workspace& workspace)
{
    workspace.session.selection.clear();
    workspace.topic = Topic::Properties;
    workspace.requests.push_back(Request::EditTitle);
}

} // namespace

void add_property_commands(CommandTable& table)
{
    Menu menu(table, translatable("Edit"));
    menu.step({"edit.new_material", translatable("New material")},
              [](Workspace& workspace) { new_material(workspace.session); });
    menu.step({"edit.title", translatable("Title and notes…")}, edit_title);
    menu.step({"edit.import_properties", translatable("Import materials and sections…")},
              [](Workspace& workspace) { workspace.requests.push_back(Request::ImportDialog); });
    menu.step({"edit.condense", translatable("Condense materials, sections and named sets")},
              [](Workspace& workspace) { condense_properties(workspace.session); });
}

void new_material(Session& session)
{
    const std::vector<MemberId> members = selected_members(session.selection);
    const femoop::Material material = pattern(session, members);
    session.change(
        {translatable("New material"), [&](Document& document) { add_material(document, material, members); }});
    session.selection = Part(MaterialId(session.model().materials.size() - 1));
}

void condense_properties(Session& session)
{
    femoop::Condensed condensed;
    session.change({translatable("Condense materials, sections and named sets"), [&](Document& document) {
                        condensed = femoop::condense(document.model);
                        const femoop::Condensed sets = condense_sets(document);
                        condensed.n_equal += sets.n_equal;
                        condensed.n_unused += sets.n_unused;
                    }});
    session.notify({translatable("Property sets: {equal} were like others, {unused} nobody used"),
                    {{"equal", text_of(condensed.n_equal)}, {"unused", text_of(condensed.n_unused)}}});
}

bool import_properties(Session& session, const std::filesystem::path& path)
{
    femoop::ModelReading reading = femoop::examine_model_file(path);
    const ui::Message::Argument file{"file", path.filename().string()};
    if (!reading.is_sound()) {
        session.notice = Notice{ui::lasting({translatable("nothing was imported from {file}"), {file}}),
                                named(errors_among(std::move(reading.faults)), reading.model)};
        return false;
    }
    Companion beside = read_companion_of(path, reading.model).companion;
    const Document other{.model = std::move(reading.model), .companion = std::move(beside)};
    std::size_t n = 0;
    session.change({{translatable("Import from {file}"), {file}}, [&](Document& document) {
                        n = import_properties(document, other.model) + import_sets(document, other);
                    }});
    session.notify({translatable("Property sets that came from {file}: {count}"), {{"count", text_of(n)}, file}});
    return true;
}

void set_title(Session& session, const std::string& title)
{
    if (session.model().title == title) return;
    session.change({translatable("Change the title"), [&](Document& document) { set_title(document, title); }});
}

void set_notes(Session& session, const std::string& notes)
{
    if (session.model().notes == notes) return;
    session.change({translatable("Change the notes"), [&](Document& document) { set_notes(document, notes); }});
}

void select_members_with(Session& session, const Part& property)
{
    const auto* const material = std::get_if<MaterialId>(&property);
    const auto members = material != nullptr ? members_with(session.model(), *material)
                                             : members_with(session.model(), std::get<SectionId>(property));
    session.selection.clear();
    for (const MemberId member : members) session.selection.add(member);
}

void duplicate(Session& session, const Part& property)
{
    const ui::Message label{translatable("Duplicate: {part}"), {{"part", title(session.model(), property)}}};
    if (const auto id = case_id_of(session.model(), property)) {
        femoop::CaseId added;
        session.change({label, [&](Document& document) { added = copy_case(document, *id); }});
        session.selection = part_of(session.model(), added);
        return show_case(session, added);
    }
    if (const auto* const material = std::get_if<MaterialId>(&property)) {
        session.change({label, [&](Document& document) { add_material(document, document.model[*material]); }});
        session.selection = Part(MaterialId(session.model().materials.size() - 1));
    } else {
        const SectionId section = std::get<SectionId>(property);
        session.change({label, [&](Document& document) { add_section(document, document.model[section]); }});
        session.selection = Part(SectionId(session.model().sections.size() - 1));
    }
}

std::optional<ui::Message> rename(Session& session, const Part& property, const std::string& name)
{
    if (const auto id = case_id_of(session.model(), property)) return rename(session, *id, name);
    const auto rename_it = [&](auto id) -> std::optional<ui::Message> {
        if (auto reason = why_not_rename(session.model(), id, name)) return reason;
        session.change({{translatable("Rename: {part}"), {{"part", title(session.model(), property)}}},
                        [&](Document& document) { rename(document, id, name); }});
        session.selection = Part(id); // a selection goes by names
        return std::nullopt;
    };
    const auto* const material = std::get_if<MaterialId>(&property);
    return material != nullptr ? rename_it(*material) : rename_it(std::get<SectionId>(property));
}

const std::string& name_of(const Model& model, const Part& property)
{
    if (const auto id = case_id_of(model, property)) return model.case_name(*id);
    const auto* const material = std::get_if<MaterialId>(&property);
    return material != nullptr ? model[*material].id : model[std::get<SectionId>(property)].id;
}

} // namespace frame
