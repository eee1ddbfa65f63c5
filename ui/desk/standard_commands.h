#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/command/menu_builder.h"
#include "ui/desk/desk.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"

/// The commands that every app has, with the same names and keys everywhere. `Desk` is an app's own (desk.h).
namespace ui::standard {

inline constexpr std::string_view file_menu = translatable("File");
inline constexpr std::string_view edit_menu = translatable("Edit");
inline constexpr std::string_view view_menu = translatable("View");
inline constexpr std::string_view help_menu = translatable("Help");

/// What the session's notice says where something was not done.
template <class Desk> Reason notice_unless(bool is_done, const Desk& desk)
{
    return is_done ? std::nullopt : Reason(desk.session.notice->sentence);
}

template <class Desk> void add_new(CommandTable<Desk>& table, std::function<void(Desk&)> begin_anew)
{
    MenuBuilder<Desk>(table, file_menu)
        .step({"file.new", translatable("New"), {{Key::N, ctrl}}}, std::move(begin_anew));
}

/// \param ask  opens the dialog \param open  a path that a scenario gives; false, with a notice, where it cannot
template <class Desk, class Open> void add_open(CommandTable<Desk>& table, std::function<void(Desk&)> ask, Open open)
{
    MenuBuilder<Desk> menu(table, file_menu);
    menu.step({"file.open", translatable("Open…"), {{Key::O, ctrl}}}, std::move(ask));
    menu.step({"file.recent", translatable("Open one of the last files…"), {{Key::O, ctrl_shift}}},
              asks(Request::RecentList));
    table.with_argument(
        "file.open", [open](Desk& desk, const Argument& path) { return notice_unless(open(desk, path.text), desk); });
}

/// \param save_as  under a path; false, with a notice, where it cannot
template <class Desk, class SaveAs> void add_save(CommandTable<Desk>& table, SaveAs save_as)
{
    MenuBuilder<Desk> menu(table, file_menu);
    menu.step({"file.save", translatable("Save"), {{Key::S, ctrl}}}, [](Desk& desk) {
        if (desk.session.path()) desk.session.save(*desk.session.path());
        else desk.asked.push_back(Request::SaveDialog);
    });
    menu.step({"file.save_as", translatable("Save as…"), {{Key::S, ctrl_shift}}}, asks(Request::SaveDialog));
    table.with_argument("file.save", [save_as](Desk& desk, const Argument& path) {
        return notice_unless(save_as(desk, path.text), desk);
    });
}

/// `label`: what can be exported, "Export picture…".
template <class Desk> void add_export(CommandTable<Desk>& table, std::string_view label)
{
    MenuBuilder<Desk>(table, file_menu)
        .step({"file.export", label, {{Key::E, ctrl_shift}}}, asks(Request::ExportDialog));
}

/// `description`: what is told in words, "Model and results in words".
template <class Desk> void add_copy_and_describe(CommandTable<Desk>& table, std::string_view description)
{
    MenuBuilder<Desk> menu(table, file_menu);
    menu.step({"file.copy_picture", translatable("Copy picture"), {{Key::C, ctrl_shift}}}, asks(Request::CopyPicture));
    menu.step({"file.describe", description, {{Key::D, ctrl_shift}}}, asks(Request::Description));
}

template <class Desk> void add_quit(CommandTable<Desk>& table, std::function<void(Desk&)> quit)
{
    MenuBuilder<Desk>(table, file_menu).step({"file.quit", translatable("Quit"), {{Key::Q, ctrl}}}, std::move(quit));
}

inline Phrase named_step(std::string_view verb, std::string_view plain, const std::optional<Phrase>& step)
{
    return step ? Phrase(verb, {{"step", *step}}) : Phrase(plain);
}

/// Of apps whose session keeps a history: `undo()`, `redo()`, `history()`.
template <class Desk> void add_undo_and_redo(CommandTable<Desk>& table)
{
    MenuBuilder<Desk> menu(table, edit_menu);
    const auto why_not_undo = [](const Desk& desk) -> Reason {
        if (desk.session.history().can_undo()) return std::nullopt;
        return translatable("nothing was changed yet");
    };
    const auto why_not_redo = [](const Desk& desk) -> Reason {
        if (desk.session.history().can_redo()) return std::nullopt;
        return translatable("nothing was undone");
    };
    menu.step(
            {"edit.undo", translatable("Undo"), {{Key::Z, ctrl}}}, [](Desk& desk) { desk.session.undo(); },
            why_not_undo)
        .live_label = [](const Desk& desk) {
        return named_step(translatable("Undo: {step}"), translatable("Undo"), desk.session.history().undo_label());
    };
    menu.step(
            {"edit.redo", translatable("Redo"), {{Key::Z, ctrl_shift}, {Key::Y, ctrl}}},
            [](Desk& desk) { desk.session.redo(); }, why_not_redo)
        .live_label = [](const Desk& desk) {
        return named_step(translatable("Redo: {step}"), translatable("Redo"), desk.session.history().redo_label());
    };
}

/// `fit`: what is shown whole, "Show the whole model", and the keys for it.
template <class Desk> void add_zoom(CommandTable<Desk>& table, std::string_view fit, const std::vector<Chord>& keys)
{
    MenuBuilder<Desk> menu(table, view_menu);
    menu.step({"view.fit", fit, std::move(keys)}, asks(Request::Fit));
    menu.step({"view.zoom_in", translatable("Zoom in"), {{Key::Plus, {}}, {Key::Plus, shift}, {Key::Plus, ctrl}}},
              asks(Request::ZoomIn));
    menu.step({"view.zoom_out", translatable("Zoom out"), {{Key::Minus, {}}, {Key::Minus, ctrl}}},
              asks(Request::ZoomOut));
}

/// Large type and the whole window for the picture, and back.
template <class Desk> void project(Desk& desk, bool is_projecting)
{
    desk.theme() = is_projecting ? ThemeName::Projector : ThemeName::Light;
    desk.give_room_to_the_picture(is_projecting);
}

template <class Desk> void add_projector(CommandTable<Desk>& table)
{
    MenuBuilder<Desk>(table, view_menu)
        .toggle(
            {"view.project", translatable("For the projector"), {{Key::F5, {}}}},
            [](const Desk& desk) { return desk.theme() == ThemeName::Projector; }, project<Desk>);
}

template <class Desk> void add_panels(CommandTable<Desk>& table)
{
    MenuBuilder<Desk>(table, view_menu)
        .toggle(
            {"view.panels", translatable("Panels"), {{Key::P, {}}}},
            [](auto& desk) -> auto& { return desk.has_panels; });
}

/// What a panel can show, each a choice; it is opened where the panels are hidden.
template <class Desk, class Entries> void add_topics(CommandTable<Desk>& table, const Entries& entries)
{
    MenuBuilder<Desk>(table, view_menu)
        .choices(
            entries, [](const Desk& desk) { return desk.topic; },
            [](Desk& desk, auto topic) {
                desk.topic = topic;
                desk.has_panels = true;
            });
}

/// What of the picture is shown or not, each a choice of a switch in the session's `look`.
template <class Desk, class Entries>
void add_look_switches(CommandTable<Desk>& table, std::string_view menu, const Entries& entries)
{
    MenuBuilder<Desk>(table, menu)
        .toggles(
            entries, [](auto& desk, auto item) -> auto& { return desk.session.look.*item; });
}

inline constexpr std::array themes{
    Choice<ThemeName>{ThemeName::Light, "view.theme.light", translatable("Light theme")},
    Choice<ThemeName>{ThemeName::Dark, "view.theme.dark", translatable("Dark theme")},
    Choice<ThemeName>{ThemeName::Print, "view.theme.print", translatable("Print theme")},
    Choice<ThemeName>{ThemeName::Projector, "view.theme.projector", translatable("Projector theme")},
};

template <class Desk> void add_themes(CommandTable<Desk>& table)
{
    MenuBuilder<Desk>(table, view_menu)
        .choices(
            themes, [](const Desk& desk) { return desk.theme(); },
            [](Desk& desk, ThemeName theme) { desk.theme() = theme; });
}

inline constexpr std::array export_scales{
    Choice<double>{1.0, "file.export_scale.1", translatable("Export PNG at 1×")},
    Choice<double>{2.0, "file.export_scale.2", translatable("Export PNG at 2×")},
    Choice<double>{3.0, "file.export_scale.3", translatable("Export PNG at 3×")},
    Choice<double>{4.0, "file.export_scale.4", translatable("Export PNG at 4×")},
};

template <class Desk> void add_export_scales(CommandTable<Desk>& table)
{
    MenuBuilder<Desk>(table, view_menu)
        .choices(
            export_scales, [](auto& desk) -> auto& { return desk.export_scale; });
}

template <class Desk> void add_languages(CommandTable<Desk>& table)
{
    MenuBuilder<Desk> menu(table, translatable("Language"));
    for (const Language language : all_languages) {
        const std::string_view id = language == Language::English ? "view.language.en" : "view.language.pt";
        menu.choice(
            Choice<Language>{language, id, native_name(language)},
            [](const Desk& desk) { return desk.tr().language(); },
            [](Desk& desk, Language chosen) { desk.set_language(chosen); });
    }
}

template <class Desk> void add_help(CommandTable<Desk>& table)
{
    MenuBuilder<Desk> menu(table, help_menu);
    menu.step({"help.palette", translatable("Find a command…"), {{Key::K, ctrl}, {Key::F3, {}}}},
              asks(Request::Palette));
    menu.step({"help.shortcuts", translatable("Keys"), {{Key::F1, {}}}}, asks(Request::ShortcutList));
}

} // namespace ui::standard
