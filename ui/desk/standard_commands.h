#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/command/command_table.h"
#include "ui/desk/desk.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"

/// The commands that every app has, with the same names and keys everywhere. `Desk` is an app's own (desk.h).
namespace ui::standard {

inline constexpr std::string_view file_menu = translatable("File");
inline constexpr std::string_view edit_menu = translatable("Edit");
inline constexpr std::string_view view_menu = translatable("View");
inline constexpr std::string_view help_menu = translatable("Help");

template <class Desk> void add_new(CommandTable<Desk>& table, std::function<void(Desk&)> begin_anew)
{
    table.add({.id = "file.new",
               .menu = file_menu,
               .label = translatable("New"),
               .shortcuts = {{Key::N, ctrl}},
               .run = std::move(begin_anew)});
}

template <class Desk> void add_open(CommandTable<Desk>& table, std::function<void(Desk&)> open)
{
    table.add({.id = "file.open",
               .menu = file_menu,
               .label = translatable("Open…"),
               .shortcuts = {{Key::O, ctrl}},
               .run = std::move(open)});
}

template <class Desk> void add_recent(CommandTable<Desk>& table)
{
    table.add({.id = "file.recent",
               .menu = file_menu,
               .label = translatable("Open one of the last files…"),
               .shortcuts = {{Key::O, ctrl_shift}},
               .run = asks(Request::RecentList)});
}

template <class Desk> void add_save(CommandTable<Desk>& table)
{
    table.add({.id = "file.save",
               .menu = file_menu,
               .label = translatable("Save"),
               .shortcuts = {{Key::S, ctrl}},
               .run = [](Desk& desk) {
                   if (desk.session.path()) desk.session.save(*desk.session.path());
                   else desk.asked.push_back(Request::SaveDialog);
               }});
    table.add({.id = "file.save_as",
               .menu = file_menu,
               .label = translatable("Save as…"),
               .shortcuts = {{Key::S, ctrl_shift}},
               .run = asks(Request::SaveDialog)});
}

/// `label`: what can be exported, "Export picture…".
template <class Desk> void add_export(CommandTable<Desk>& table, std::string_view label)
{
    table.add({.id = "file.export",
               .menu = file_menu,
               .label = label,
               .shortcuts = {{Key::E, ctrl_shift}},
               .run = asks(Request::ExportDialog)});
}

/// `description`: what is told in words, "Model and results in words".
template <class Desk> void add_copy_and_describe(CommandTable<Desk>& table, std::string_view description)
{
    table.add({.id = "file.copy_picture",
               .menu = file_menu,
               .label = translatable("Copy picture"),
               .shortcuts = {{Key::C, ctrl_shift}},
               .run = asks(Request::CopyPicture)});
    table.add({.id = "file.describe",
               .menu = file_menu,
               .label = description,
               .shortcuts = {{Key::D, ctrl_shift}},
               .run = asks(Request::Description)});
}

template <class Desk> void add_quit(CommandTable<Desk>& table, std::function<void(Desk&)> quit)
{
    table.add({.id = "file.quit",
               .menu = file_menu,
               .label = translatable("Quit"),
               .shortcuts = {{Key::Q, ctrl}},
               .run = std::move(quit)});
}

inline Phrase named_step(std::string_view verb, std::string_view plain, const std::optional<Phrase>& step)
{
    return step ? Phrase(verb, {{"step", *step}}) : Phrase(plain);
}

/// Of apps whose session keeps a history: `undo()`, `redo()`, `history()`.
template <class Desk> void add_undo_and_redo(CommandTable<Desk>& table)
{
    table.add({.id = "edit.undo",
               .menu = edit_menu,
               .label = translatable("Undo"),
               .shortcuts = {{Key::Z, ctrl}},
               .run = [](Desk& desk) { desk.session.undo(); },
               .why_not = [](const Desk& desk) -> std::optional<Phrase> {
                   if (desk.session.history().can_undo()) return std::nullopt;
                   return translatable("nothing was changed yet");
               },
               .live_label =
                   [](const Desk& desk) {
                       return named_step(translatable("Undo: {step}"), translatable("Undo"),
                                         desk.session.history().undo_label());
                   }});
    table.add({.id = "edit.redo",
               .menu = edit_menu,
               .label = translatable("Redo"),
               .shortcuts = {{Key::Z, ctrl_shift}, {Key::Y, ctrl}},
               .run = [](Desk& desk) { desk.session.redo(); },
               .why_not = [](const Desk& desk) -> std::optional<Phrase> {
                   if (desk.session.history().can_redo()) return std::nullopt;
                   return translatable("nothing was undone");
               },
               .live_label =
                   [](const Desk& desk) {
                       return named_step(translatable("Redo: {step}"), translatable("Redo"),
                                         desk.session.history().redo_label());
                   }});
}

/// `fit`: what is shown whole, "Show the whole model", and the keys for it.
template <class Desk> void add_zoom(CommandTable<Desk>& table, std::string_view fit, std::vector<Chord> keys)
{
    table.add(
        {.id = "view.fit", .menu = view_menu, .label = fit, .shortcuts = std::move(keys), .run = asks(Request::Fit)});
    table.add({.id = "view.zoom_in",
               .menu = view_menu,
               .label = translatable("Zoom in"),
               .shortcuts = {{Key::Plus, {}}, {Key::Plus, shift}, {Key::Plus, ctrl}},
               .run = asks(Request::ZoomIn)});
    table.add({.id = "view.zoom_out",
               .menu = view_menu,
               .label = translatable("Zoom out"),
               .shortcuts = {{Key::Minus, {}}, {Key::Minus, ctrl}},
               .run = asks(Request::ZoomOut)});
}

/// Large type and the whole window for the picture, and back.
template <class Desk> void project(Desk& desk)
{
    const bool is_projecting = desk.theme() == ThemeName::Projector;
    desk.theme() = is_projecting ? ThemeName::Light : ThemeName::Projector;
    desk.give_room_to_the_picture(!is_projecting);
}

template <class Desk> void add_projector(CommandTable<Desk>& table)
{
    table.add({.id = "view.project",
               .menu = view_menu,
               .label = translatable("For the projector"),
               .shortcuts = {{Key::F5, {}}},
               .run = project<Desk>,
               .is_on = [](const Desk& desk) { return desk.theme() == ThemeName::Projector; }});
}

template <class Desk> void add_panels(CommandTable<Desk>& table)
{
    table.add({.id = "view.panels",
               .menu = view_menu,
               .label = translatable("Panels"),
               .shortcuts = {{Key::P, {}}},
               .run = [](Desk& desk) { desk.has_panels = !desk.has_panels; },
               .is_on = [](const Desk& desk) { return desk.has_panels; }});
}

/// What a panel can show, each with a `topic`, an `id` and a `label`; it is opened where the panels are hidden.
template <class Desk, class Entries> void add_topics(CommandTable<Desk>& table, const Entries& entries)
{
    for (const auto& entry : entries)
        table.add({.id = entry.id,
                   .menu = view_menu,
                   .label = entry.label,
                   .run =
                       [topic = entry.topic](Desk& desk) {
                           desk.topic = topic;
                           desk.has_panels = true;
                       },
                   .is_on = [topic = entry.topic](const Desk& desk) { return desk.topic == topic; }});
}

/// What of the picture is shown or not, each with an `id`, a `label`, a `key` that Shift goes with, and as `item` the
/// switch in the session's `look`.
template <class Desk, class Entries>
void add_look_switches(CommandTable<Desk>& table, std::string_view menu, const Entries& entries)
{
    for (const auto& entry : entries)
        table.add({.id = entry.id,
                   .menu = menu,
                   .label = entry.label,
                   .shortcuts = {{entry.key, shift}},
                   .run = [item = entry.item](Desk& desk) { desk.session.look.*item = !(desk.session.look.*item); },
                   .is_on = [item = entry.item](const Desk& desk) { return desk.session.look.*item; }});
}

template <class Desk> void add_themes(CommandTable<Desk>& table)
{
    struct Entry {
        ThemeName theme;
        std::string_view id, label;
    };
    for (const Entry& entry : {Entry{ThemeName::Light, "view.theme.light", translatable("Light theme")},
                               Entry{ThemeName::Dark, "view.theme.dark", translatable("Dark theme")},
                               Entry{ThemeName::Print, "view.theme.print", translatable("Print theme")},
                               Entry{ThemeName::Projector, "view.theme.projector", translatable("Projector theme")}})
        table.add({.id = entry.id,
                   .menu = view_menu,
                   .label = entry.label,
                   .run = [theme = entry.theme](Desk& desk) { desk.theme() = theme; },
                   .is_on = [theme = entry.theme](const Desk& desk) { return desk.theme() == theme; }});
}

template <class Desk> void add_export_scales(CommandTable<Desk>& table)
{
    struct Entry {
        double scale;
        std::string_view id, label;
    };
    for (const Entry& entry : {Entry{1.0, "file.export_scale.1", translatable("Export PNG at 1×")},
                               Entry{2.0, "file.export_scale.2", translatable("Export PNG at 2×")},
                               Entry{3.0, "file.export_scale.3", translatable("Export PNG at 3×")},
                               Entry{4.0, "file.export_scale.4", translatable("Export PNG at 4×")}})
        table.add({.id = entry.id,
                   .menu = view_menu,
                   .label = entry.label,
                   .run = [scale = entry.scale](Desk& desk) { desk.export_scale = scale; },
                   .is_on = [scale = entry.scale](const Desk& desk) { return desk.export_scale == scale; }});
}

template <class Desk> void add_languages(CommandTable<Desk>& table)
{
    for (const Language language : all_languages)
        table.add({.id = language == Language::English ? "view.language.en" : "view.language.pt",
                   .menu = translatable("Language"),
                   .label = native_name(language),
                   .run = [language](Desk& desk) { desk.set_language(language); },
                   .is_on = [language](const Desk& desk) { return desk.tr().language() == language; }});
}

template <class Desk> void add_help(CommandTable<Desk>& table)
{
    table.add({.id = "help.palette",
               .menu = help_menu,
               .label = translatable("Find a command…"),
               .shortcuts = {{Key::K, ctrl}, {Key::F3, {}}},
               .run = asks(Request::Palette)});
    table.add({.id = "help.shortcuts",
               .menu = help_menu,
               .label = translatable("Keys"),
               .shortcuts = {{Key::F1, {}}},
               .run = asks(Request::ShortcutList)});
}

} // namespace ui::standard
