#pragma once

#include <imgui.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "ui/app/app.h"
#include "ui/app/kept_files.h"
#include "ui/app/overlays.h"
#include "ui/app/picture_area.h"
#include "ui/app/unsaved_changes.h"
#include "ui/command/command_table.h"
#include "ui/context/write_picture.h"
#include "ui/files/linked_copy.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/offer.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/words_window.h"

namespace ui {

/// What an app says of itself and of its files.
struct AppFace {
    std::string_view name;        ///< in the window's title: "Cremona: Mohr's circle"
    std::string_view description; ///< of the window with the document in words
    FileKind files;
    SidePanels sides;
};

/// An app of one document at a time on a context, on the screen or off it: menus, keys, dialogs, drafts, export, and
/// panels on either side of the picture. An app adds its panels and its picture. Each frame goes one way: input, edits,
/// solution, picture. `Desk` is the app's own (ui/desk/document_desk.h).
template <class Desk> class DocumentApp : public App {
public:
    using Session = decltype(Desk::session);

    void frame(const Input& input) final;
    bool is_moving() const final { return session().is_moving(); }
    void ask_to_quit() final { desk_.leave_document(asks(Request::Quit)); }
    bool wants_to_quit() const final { return wants_to_quit_; }
    std::string window_title() const final
    {
        return (session().is_dirty() ? "*" : "") + session().file_name() + " – " + session().tr()(face_.name);
    }
    ImGuiSession& gui() final { return gui_; }

    Desk& desk() { return desk_; }
    const Session& session() const { return desk_.session; }
    const CommandTable<Desk>& commands() const { return commands_; }
    /// From now on the last files and drafts of unsaved work are kept there. Offers what was left behind.
    void remember_in(const DraftFolder& folder) { kept_files_ = KeptFiles(folder); }
    /// From now on changes are offered to the program at the other end, and those of that program here. The session
    /// knows `linked_text()`, `is_news(text)` and `take_over(text)`; what has them not has no links.
    void link_to(Link link);
    const std::optional<LinkedCopy>& linked() const { return linked_; }
    /// Writes the picture to a file (.png, .svg or .pdf), or what else the app can write, and tells that it did.
    /// \returns why it cannot
    std::optional<Phrase> export_as(const std::filesystem::path& path);

protected:
    /// \pre context and fonts outlive the application
    DocumentApp(Context& context, const Fonts& fonts, Session session, CommandTable<Desk> commands, AppFace face)
        : desk_(std::move(session)),
          commands_(std::move(commands)),
          gui_(context, fonts, Theme(desk_.session.look.theme)),
          context_(context),
          fonts_(fonts),
          face_(std::move(face)),
          overlays_(face_.files),
          theme_(desk_.session.look.theme)
    {}

    virtual Picture picture() = 0;                                          ///< to be exported
    virtual std::optional<Phrase> write(const std::filesystem::path& path); ///< \returns why it cannot
    virtual bool is_typing() const = 0;                                     ///< in a panel, whatever is pressed
    virtual void show_left() = 0;
    virtual void show_right() = 0;
    virtual void show_canvas() = 0;
    virtual std::string status() const = 0;
    virtual std::string words() const = 0; ///< that tell the document
    virtual void show_body() { show_panels_and_canvas(); }
    virtual void take(Request request) { (void)request; } ///< what not every app is asked for
    virtual void take_own_requests() {}

    void show_panels_and_canvas();
    const Fonts& fonts() const { return fonts_; }

private:
    void take_keys(const Input& input);
    void take_requests();
    void take_common(Request request);
    void take(const ChosenFile& file);
    void show_menu_bar();
    std::optional<FootMessage> notice() const;
    void follow_link(double seconds);
    void show_link();
    void show_dialogs();
    void ask_about_unsaved();
    void copy_picture();
    void quit();
    PictureLook picture_look() const
    {
        return {.background = Theme(session().look.theme).background(),
                .title = session().file_name(),
                .png_scale = desk_.export_scale};
    }

    Desk desk_;
    CommandTable<Desk> commands_;
    ImGuiSession gui_;
    Context& context_;
    const Fonts& fonts_;
    AppFace face_;
    Overlays overlays_;
    UnsavedChanges unsaved_changes_;
    KeptFiles kept_files_{std::nullopt};
    ThemeName theme_;
    std::optional<LinkedCopy> linked_;
    bool wants_to_quit_ = false;
};

/// Sessions of documents that another program can have a copy of.
template <class Session>
concept Linkable = requires(Session session, const std::string& text)
{
    session.linked_text();
    session.is_news(text);
    session.take_over(text);
};

/// A tab for each topic of a panel: `topics` are choices.
template <class Desk, class Topics> void show_topics(Desk& desk, const Topics& topics)
{
    TabRow row;
    for (const auto& entry : topics) {
        const std::string title = desk.tr()(entry.label) + "###" + std::string(entry.id);
        if (row.show(title, entry.value == desk.topic)) desk.topic = entry.value;
    }
    ImGui::Separator();
}

template <class Desk> void DocumentApp<Desk>::frame(const Input& input)
{
    if (std::exchange(theme_, session().look.theme) != session().look.theme) gui_.set_theme(Theme(theme_));
    if (!input.dropped_files.empty()) desk_.open(input.dropped_files.front());
    gui_.begin_frame(input);
    take_keys(input);
    desk_.session.tick(input.seconds);
    follow_link(input.seconds);
    show_menu_bar();
    const auto told = notice();
    begin_body(told ? height(*told) : status_height());
    show_body();
    end_body();
    if (!told) status_bar(status());
    else if (show(*told)) desk_.session.notice.reset();
    show_dialogs();
    take_requests();
    kept_files_.tick(desk_, logical_size(context_), input.seconds);
    gui_.end_frame();
}

template <class Desk> void DocumentApp<Desk>::take_keys(const Input& input)
{
    const bool is_popup_open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    if (overlays_.takes_keys() || kept_files_.is_open() || desk_.after_question || is_popup_open) return;
    const bool types = ImGui::GetIO().WantTextInput || is_typing();
    for (const KeyEvent& event : input.keys) {
        const bool is_escape = event.key == Key::Escape;
        const bool edits_text = ImGui::GetIO().WantTextInput && is_edit_of_text(event.chord());
        const bool is_for_field = edits_text || (types && !is_escape && !event.modifiers.ctrl);
        if (!event.is_down || is_for_field || (is_escape && overlays_.put_away())) continue;
        const auto* const command = commands_.find(event.chord());
        if (command == nullptr) continue;
        const auto reason = run(*command, desk_);
        ImGui::GetIO().ClearInputCharacters(); // the letter was a command, and none for a field that this opens
        if (reason && !is_escape) desk_.tell(*reason);
    }
}

template <class Desk> void DocumentApp<Desk>::take_requests()
{
    for (const Request request : std::exchange(desk_.asked, {})) take_common(request);
    take_own_requests();
}

template <class Desk> void DocumentApp<Desk>::take_common(Request request)
{
    if (overlays_.take(request, session().path()) || kept_files_.take(request)) return;
    if (request == Request::CopyPicture) copy_picture();
    else if (request == Request::Quit) quit();
    else take(request);
}

template <class Desk> void DocumentApp<Desk>::take(const ChosenFile& file)
{
    using enum ChosenFile::Purpose;
    switch (file.purpose) {
    case Open: desk_.session.open(file.path); break;
    case Save:
        if (!desk_.session.save(file.path)) overlays_.refuse(desk_.session.notice->sentence);
        break;
    case Export:
        if (const auto reason = export_as(file.path)) overlays_.refuse(*reason);
        break;
    }
}

template <class Desk> void DocumentApp<Desk>::quit()
{
    kept_files_.end();
    wants_to_quit_ = true;
}

template <class Desk> void DocumentApp<Desk>::show_menu_bar()
{
    if (!ImGui::BeginMainMenuBar()) return;
    show_menus(commands_, desk_, Catalogue(session().tr())); // a command may change the language
    show_link();
    menu_bar_title((session().is_dirty() ? "* " : "") + session().file_name());
    ImGui::EndMainMenuBar();
}

template <class Desk> void DocumentApp<Desk>::link_to(Link link)
{
    if constexpr (Linkable<Session>) linked_.emplace(std::move(link), session().linked_text());
}

template <class Desk> void DocumentApp<Desk>::follow_link(double seconds)
{
    if constexpr (Linkable<Session>)
        if (linked_)
            linked_->tick(seconds, {[this] { return session().linked_text(); },
                                    [this](const std::string& other) { return session().is_news(other); }});
}

template <class Desk> void DocumentApp<Desk>::show_link()
{
    if constexpr (Linkable<Session>) {
        if (!linked_ || !linked_->offered()) return;
        const auto answer = show_offer(session().tr()("the frame has changed"), session().tr());
        if (answer == OfferAnswer::TakeOver) desk_.session.take_over(linked_->take());
        if (answer == OfferAnswer::Keep) linked_->keep();
    }
}

template <class Desk> void DocumentApp<Desk>::show_panels_and_canvas()
{
    if (!desk_.has_panels) return show_canvas();
    const auto panel = [](const char* id, float width, const auto& show) {
        begin_panel(id, width);
        show();
        end_panel();
    };
    face_.sides.show([&](float width) { panel("###left", width, [this] { show_left(); }); },
                     [&](float width) { panel("###right", width, [this] { show_right(); }); },
                     [this] { show_canvas(); });
}

template <class Desk> std::optional<FootMessage> DocumentApp<Desk>::notice() const
{
    if (!session().notice) return std::nullopt;
    const Catalogue& tr = session().tr();
    return FootMessage{{tr(session().notice->sentence)}, {tr("Close") + "###close notice"}};
}

template <class Desk> void DocumentApp<Desk>::show_dialogs()
{
    const Catalogue tr = session().tr(); // a command may change the language
    if (const auto file = overlays_.show_dialog(tr)) take(*file);
    overlays_.show_palette_and_keys(commands_, desk_);
    if (overlays_.shows_description()) words_window(tr(face_.description), words(), tr, overlays_.shows_description());
    kept_files_.show(desk_);
    if (desk_.after_question) ask_about_unsaved();
}

// What was asked for goes on once the changes are saved or given up.
template <class Desk> void DocumentApp<Desk>::ask_about_unsaved()
{
    const auto fate = unsaved_changes_.ask(desk_.session, overlays_, session().tr());
    if (!fate) return;
    const auto then = std::exchange(desk_.after_question, {});
    if (*fate != UnsavedChanges::Fate::Kept) then(desk_);
}

template <class Desk> std::optional<Phrase> DocumentApp<Desk>::write(const std::filesystem::path& path)
{
    return write_picture(path, picture(), fonts_, picture_look());
}

template <class Desk> std::optional<Phrase> DocumentApp<Desk>::export_as(const std::filesystem::path& path)
{
    const auto reason = write(path);
    context_.make_current(); // a PNG is drawn in a context of its own
    if (!reason) desk_.tell({translatable("{file} was written"), {{"file", path.filename().string()}}});
    return reason;
}

template <class Desk> void DocumentApp<Desk>::copy_picture()
{
    const auto reason = ui::copy_picture(picture(), fonts_, picture_look());
    context_.make_current(); // it is drawn in a context of its own
    desk_.tell(reason.value_or(Phrase(translatable("the picture was copied"))));
}

} // namespace ui
