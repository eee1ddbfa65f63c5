#pragma once

#include <array>
#include <concepts>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/command/menu_builder.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/workspace/workspace.h"

/// The commands that every app has, with the same names and keys everywhere. `Workspace` is an app's own (workspace.h).
namespace ui::standard {

inline constexpr std::string_view file_menu = translatable("File");
inline constexpr std::string_view edit_menu = translatable("Edit");
inline constexpr std::string_view view_menu = translatable("View");
inline constexpr std::string_view help_menu = translatable("Help");

/// What the session's notice says where something was not done.
template <class Workspace> Reason notice_unless(bool is_done, const Workspace& workspace)
{
    return is_done ? std::nullopt : Reason(workspace.session.notice->sentence);
}

template <class Workspace> void add_new(CommandTable<Workspace>& table, std::function<void(Workspace&)> new_document)
{
    MenuBuilder<Workspace>(table, file_menu)
        .step({"file.new", translatable("New"), {{Key::N, ctrl}}}, std::move(new_document));
}

/// \param ask  opens the dialog
template <class Workspace> void add_open(CommandTable<Workspace>& table, std::function<void(Workspace&)> ask)
{
    MenuBuilder<Workspace> menu(table, file_menu);
    menu.step({"file.open", translatable("Open…"), {{Key::O, ctrl}}}, std::move(ask));
    menu.step({"file.recent", translatable("Open one of the last files…"), {{Key::O, ctrl_shift}}},
              asks(Request::RecentList));
    table.with_argument("file.open", [](Workspace& workspace, const Argument& path) {
        return notice_unless(workspace.open_at_once(path.text), workspace);
    });
}

template <class Workspace> void add_save(CommandTable<Workspace>& table)
{
    MenuBuilder<Workspace> menu(table, file_menu);
    menu.step({"file.save", translatable("Save"), {{Key::S, ctrl}}}, [](Workspace& workspace) {
        if (workspace.session.path()) workspace.session.save(*workspace.session.path());
        else workspace.asked.push_back(Request::SaveDialog);
    });
    menu.step({"file.save_as", translatable("Save as…"), {{Key::S, ctrl_shift}}}, asks(Request::SaveDialog));
    table.with_argument("file.save", [](Workspace& workspace, const Argument& path) {
        return notice_unless(workspace.save_as(path.text), workspace);
    });
}

/// `label`: what can be exported, "Export picture…".
template <class Workspace> void add_export(CommandTable<Workspace>& table, std::string_view label)
{
    MenuBuilder<Workspace>(table, file_menu)
        .step({"file.export", label, {{Key::E, ctrl_shift}}}, asks(Request::ExportDialog));
}

/// `description`: what is told in words, "Model and results in words".
template <class Workspace> void add_copy_and_describe(CommandTable<Workspace>& table, std::string_view description)
{
    MenuBuilder<Workspace> menu(table, file_menu);
    menu.step({"file.copy_picture", translatable("Copy picture"), {{Key::C, ctrl_shift}}}, asks(Request::CopyPicture));
    menu.step({"file.describe", description, {{Key::D, ctrl_shift}}}, asks(Request::Description));
}

template <class Workspace> void add_quit(CommandTable<Workspace>& table)
{
    MenuBuilder<Workspace>(table, file_menu)
        .step({"file.quit", translatable("Quit"), {{Key::Q, ctrl}}},
              [](Workspace& workspace) { workspace.leave_all(asks(Request::Quit)); });
}

inline Message named_step(std::string_view verb, std::string_view plain, const std::optional<Message>& step)
{
    return step ? Message(verb, {{"step", *step}}) : Message(plain);
}

/// Of apps whose hand draws by several places before there is a step: the last of them is what is undone.
template <class Workspace>
concept TakesPlacesBack = requires(Workspace& workspace)
{
    {
        workspace.hand.has_places_to_take_back()
        } -> std::same_as<bool>;
    workspace.hand.take_place_back();
};

template <class Workspace> bool has_places_to_take_back(const Workspace& workspace)
{
    if constexpr (TakesPlacesBack<Workspace>) return workspace.hand.has_places_to_take_back();
    else return false;
}

template <class Workspace> void undo(Workspace& workspace)
{
    if constexpr (TakesPlacesBack<Workspace>)
        if (workspace.hand.has_places_to_take_back()) return workspace.hand.take_place_back();
    workspace.session.undo();
}

/// Of apps whose session keeps a history: `undo()`, `redo()`, `history()`.
template <class Workspace> void add_undo_and_redo(CommandTable<Workspace>& table)
{
    MenuBuilder<Workspace> menu(table, edit_menu);
    const auto why_not_undo = [](const Workspace& workspace) -> Reason {
        if (has_places_to_take_back(workspace) || workspace.session.history().can_undo()) return std::nullopt;
        return translatable("nothing was changed yet");
    };
    const auto why_not_redo = [](const Workspace& workspace) -> Reason {
        if (workspace.session.history().can_redo()) return std::nullopt;
        return translatable("nothing was undone");
    };
    menu.step(
            {"edit.undo", translatable("Undo"), {{Key::Z, ctrl}}}, [](Workspace& workspace) { undo(workspace); },
            why_not_undo)
        .live_label = [](const Workspace& workspace) {
        if (has_places_to_take_back(workspace)) return Message(translatable("Undo: the last place"));
        return named_step(translatable("Undo: {step}"), translatable("Undo"), workspace.session.history().undo_label());
    };
    menu.step(
            {"edit.redo", translatable("Redo"), {{Key::Z, ctrl_shift}, {Key::Y, ctrl}}},
            [](Workspace& workspace) { workspace.session.redo(); }, why_not_redo)
        .live_label = [](const Workspace& workspace) {
        return named_step(translatable("Redo: {step}"), translatable("Redo"), workspace.session.history().redo_label());
    };
}

/// `fit`: what is shown whole, "Show the whole model", and the keys for it.
template <class Workspace>
void add_zoom(CommandTable<Workspace>& table, std::string_view fit, const std::vector<Chord>& keys)
{
    MenuBuilder<Workspace> menu(table, view_menu);
    menu.step({"view.fit", fit, keys}, asks(Request::Fit));
    menu.step({"view.zoom_in", translatable("Zoom in"), {{Key::Plus, {}}, {Key::Plus, shift}, {Key::Plus, ctrl}}},
              asks(Request::ZoomIn));
    menu.step({"view.zoom_out", translatable("Zoom out"), {{Key::Minus, {}}, {Key::Minus, ctrl}}},
              asks(Request::ZoomOut));
}

/// Large type and the whole window for the picture, and back.
template <class Workspace> void project(Workspace& workspace, bool is_projecting)
{
    if (is_projecting) workspace.theme_at_desk = workspace.theme();
    workspace.theme() = is_projecting ? ThemeName::Projector : workspace.theme_at_desk;
    workspace.set_panels_visible(!is_projecting);
}

template <class Workspace> void add_projector(CommandTable<Workspace>& table)
{
    MenuBuilder<Workspace>(table, view_menu)
        .toggle(
            {"view.project", translatable("For the projector"), {{Key::F5, {}}}},
            [](const Workspace& workspace) { return workspace.theme() == ThemeName::Projector; }, project<Workspace>);
}

/// Of apps that are linked with another one: what its window offers is answered as by its buttons (ui/widgets/offer.h).
template <class Workspace> void add_offer(CommandTable<Workspace>& table)
{
    MenuBuilder<Workspace> menu(table, edit_menu);
    const auto why_not = [](const Workspace& workspace) -> Reason {
        if (!workspace.offer.empty()) return std::nullopt;
        return translatable("no linked window offers a change");
    };
    menu.step({"edit.take_over", translatable("Take over what the linked window has changed")}, asks(Request::TakeOver),
              why_not);
    menu.step({"edit.keep", translatable("Keep this as it is")}, asks(Request::KeepAsItIs), why_not);
}

template <class Workspace> void add_panels(CommandTable<Workspace>& table)
{
    MenuBuilder<Workspace>(table, view_menu)
        .toggle(
            {"view.panels", translatable("Panels"), {{Key::P, {}}}},
            [](auto& workspace) -> auto& { return workspace.has_panels; });
}

/// What a panel can show, each a choice; it is opened where the panels are hidden.
template <class Workspace, class Entries> void add_topics(CommandTable<Workspace>& table, const Entries& entries)
{
    MenuBuilder<Workspace>(table, view_menu)
        .choices(
            entries, [](const Workspace& workspace) { return workspace.topic; },
            [](Workspace& workspace, auto topic) {
                workspace.topic = topic;
                workspace.has_panels = true;
            });
}

/// What of the picture is shown or not, each a choice of a switch in the session's `look`.
template <class Workspace, class Entries>
void add_look_switches(CommandTable<Workspace>& table, std::string_view menu, const Entries& entries)
{
    MenuBuilder<Workspace>(table, menu)
        .toggles(
            entries, [](auto& workspace, auto item) -> auto& { return workspace.session.look.*item; });
}

inline constexpr std::array themes{
    Choice<ThemeName>{ThemeName::Light, "view.theme.light", translatable("Light theme")},
    Choice<ThemeName>{ThemeName::Dark, "view.theme.dark", translatable("Dark theme")},
    Choice<ThemeName>{ThemeName::Print, "view.theme.print", translatable("Print theme")},
    Choice<ThemeName>{ThemeName::Projector, "view.theme.projector", translatable("Projector theme")},
};

template <class Workspace> void add_themes(CommandTable<Workspace>& table)
{
    MenuBuilder<Workspace>(table, view_menu)
        .choices(
            themes, [](const Workspace& workspace) { return workspace.theme(); },
            [](Workspace& workspace, ThemeName theme) { workspace.theme() = theme; });
}

inline constexpr std::array export_scales{
    Choice<double>{1.0, "file.export_scale.1", translatable("Export PNG at 1×")},
    Choice<double>{2.0, "file.export_scale.2", translatable("Export PNG at 2×")},
    Choice<double>{3.0, "file.export_scale.3", translatable("Export PNG at 3×")},
    Choice<double>{4.0, "file.export_scale.4", translatable("Export PNG at 4×")},
};

template <class Workspace> void add_export_scales(CommandTable<Workspace>& table)
{
    MenuBuilder<Workspace>(table, view_menu)
        .choices(
            export_scales, [](auto& workspace) -> auto& { return workspace.export_scale; });
}

template <class Workspace> void add_languages(CommandTable<Workspace>& table)
{
    MenuBuilder<Workspace> menu(table, translatable("Language"));
    for (const Language language : all_languages) {
        const std::string_view id = language == Language::English ? "view.language.en" : "view.language.pt";
        menu.choice(
            Choice<Language>{language, id, native_name(language)},
            [](const Workspace& workspace) { return workspace.tr().language(); },
            [](Workspace& workspace, Language chosen) { workspace.set_language(chosen); });
    }
}

template <class Workspace> void add_help(CommandTable<Workspace>& table)
{
    MenuBuilder<Workspace> menu(table, help_menu);
    menu.step({"help.palette", translatable("Find a command…"), {{Key::K, ctrl}, {Key::F3, {}}}},
              asks(Request::Palette));
    menu.step({"help.shortcuts", translatable("Keys"), {{Key::F1, {}}}}, asks(Request::ShortcutList));
}

} // namespace ui::standard
