#pragma once

#include <imgui.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/app/app.h"
#include "ui/app/dialogs.h"
#include "ui/app/picture_area.h"
#include "ui/app/session_store.h"
#include "ui/app/unsaved_changes.h"
#include "ui/command/command_table.h"
#include "ui/context/write_picture.h"
#include "ui/files/linked_copy.h"
#include "ui/text/shortened.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/kept_field.h"
#include "ui/widgets/offer.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/text_window.h"

namespace ui {

/// What an app says of itself and of its files.
struct AppFace {
    std::string_view name;        ///< in the window's title: "Cremona: Mohr's circle"
    std::string_view description; ///< of the window with the document in words
    FileKind files;
    SidePanels sides;
};

/// An app on a context, on the screen or off it: menus, keys, dialogs, drafts, export, other programs, and panels on
/// either side of the picture. An app adds its panels and its picture. Each frame goes one way: input, edits, solution,
/// picture. `Workspace` is the app's own (ui/workspace/workspace.h), of one document or of several.
template <class Workspace> class DocumentApp : public App {
public:
    using Session = decltype(Workspace::session);

    void frame(const Input& input) final;
    bool is_moving() const final { return workspace_.is_moving() || awaited_export_ || !held_keys_.empty(); }
    void ask_to_quit() final { workspace_.leave_all(asks(Request::Quit)); }
    bool wants_to_quit() const final { return wants_to_quit_; }
    std::string window_title() const final
    {
        return (session().is_dirty() ? "*" : "") + workspace_.name() + " – " + session().tr()(face_.name);
    }
    ExportToApp copy_of_document() const final
    {
        ExportToApp copy{.program = {}, .document = session().document_text(), .options = common_look()};
        for (std::string& option : own_look()) copy.options.push_back(std::move(option));
        return copy;
    }
    std::string document_in_words() const final { return words(); }
    std::optional<std::string> replace_document(const std::filesystem::path& path) final
    {
        if (workspace_.session.open_copy(path)) return std::nullopt;
        if (!session().notice) return path.string();
        const std::string reason = session().tr()(session().notice->sentence);
        workspace_.session.notice.reset(); // who asked is told
        return reason;
    }
    std::optional<std::string> run_command(const std::string& id, const std::string& argument) final
    {
        return run_by_name(commands_, {id, argument}, workspace_);
    }
    ImGuiSession& gui() final { return gui_; }
    const ImGuiSession& gui() const final { return gui_; }

    Workspace& workspace() { return workspace_; }
    const Workspace& workspace() const { return workspace_; }
    const Session& session() const { return workspace_.session; }
    const CommandTable<Workspace>& commands() const { return commands_; }
    /// From now on the last files, drafts of unsaved work and settings are kept there, but for those that were asked for
    /// this time alone. Offers what was left behind.
    void remember_in(const DraftFolder& folder, const Settings& asked_for)
    {
        session_store_ = SessionStore(folder, asked_for);
    }
    /// From now on changes are offered to the program at the other end, and those of that program here. The session
    /// knows `linked_text()`, `is_news(text)` and `adopt(text)`; what has them not has no links.
    void link_to(Link link);
    const std::optional<LinkedCopy>& linked() const { return linked_; }
    /// The picture fills the window: no menus, no panels, and a foot where something is told alone.
    void show_picture_alone() { is_bare_ = true; }
    void hide_tools() { has_tools_ = false; }
    /// How another program of the suite is started, which says why it could not be; without it none is.
    using StartProgram = std::function<std::optional<Message>(const ExportToApp&)>;
    void start_programs_by(StartProgram start) { start_program_ = std::move(start); }
    const std::optional<ExportToApp>& handed() const { return handed_; } ///< what another program was given last
    /// Writes the picture to a file (.png, .svg or .pdf), or what else the app can write, and tells that it did.
    /// \returns why it cannot
    std::optional<Message> export_as(const std::filesystem::path& path);

protected:
    /// \pre context and fonts outlive the application
    DocumentApp(Context& context, const Fonts& fonts, Session session, CommandTable<Workspace> commands, AppFace face)
        : workspace_(std::move(session)),
          commands_(std::move(commands)),
          gui_(context, fonts, Theme(workspace_.theme())),
          context_(context),
          fonts_(fonts),
          face_(std::move(face)),
          dialogs_(face_.files),
          theme_(workspace_.theme())
    {}

    // ---- what every app has

    virtual Picture picture() = 0; ///< to be exported
    virtual void show_left() = 0;
    virtual void show_right() = 0;
    virtual void show_canvas() = 0;
    virtual void show_status() const = 0;  ///< at the window's foot, where nothing is told there
    virtual std::string words() const = 0; ///< that tell the document
    virtual bool is_typing() const = 0;    ///< in a panel, whatever is pressed

    // ---- what some have

    virtual void show_body() { show_panels_and_canvas(); }
    virtual void show_beside_words() {} ///< more buttons
    /// Whether undo is the document's although a field of text has the keyboard: nothing was typed into it.
    virtual bool leaves_undo() const { return false; }
    /// Options of the command line that show the document as it is shown, but for the language and the theme.
    virtual std::vector<std::string> own_look() const { return {}; }
    virtual void show_own_dialogs() {}
    virtual void handle_own_requests() {}
    virtual float covered_width() const
    {
        return 0.0F;
    }                     ///< at the right, by a window that the picture lies beside [px]
    virtual void fit() {} ///< the picture shows everything
    virtual void zoom(double factor) { (void)factor; }
    virtual std::optional<Message> write(const std::filesystem::path& path); ///< \returns why it cannot
    virtual std::string_view written() const { return translatable("{file} was written"); }

    virtual bool is_asking() const { return false; } ///< in a dialog of the app's own, which has the keys
    virtual void leave_keys_to_dialog() {}           ///< of the app's own, or of every app's
    virtual std::vector<KeyEvent> take_keys(const Input& input) { return input.keys; } ///< \returns what is left
    virtual void settle_fields() { settle_field(); } ///< what is half typed is confirmed
    /// A field, what was settled: its document is neither saved nor left.
    virtual bool refuses_text() const { return false; }
    virtual bool close_topmost() { return dialogs_.close_topmost(); } ///< what Escape is for before it is a command

    virtual std::optional<FootMessage> foot_message() const;
    virtual void answer(const FootMessage& message, std::size_t pressed);
    virtual void follow_links(double seconds);
    virtual void answer_offer(Request request);
    virtual void start(const ExportToApp& exported);
    std::optional<Message> start_program(const ExportToApp& exported) const { return start_program_(exported); }

    bool has_tools() const { return has_tools_; } ///< of an app that has a bar of them
    void show_panels_and_canvas();
    /// The same above something of a height [px]; none where that is 0.
    void show_panels_and_canvas_above(float height, const std::function<void()>& below);
    const Fonts& fonts() const { return fonts_; }

private:
    bool keeps_panels_still(const Input& input);
    void handle_keys(const Input& input);
    void run_command_of(const KeyEvent& event);
    void project_by(const Input& input); ///< with a window open, which is read from afar too
    void handle_requests();
    void handle_common_request(Request request);
    void handle_file(const ChosenFile& file);
    void begin_export(const std::filesystem::path& path);
    void go_on_with_export();
    void hand_over(ExportToApp exported);
    /// Options for every app: it speaks and looks as this one does.
    std::vector<std::string> common_look() const
    {
        return {"--lang", std::string(code(session().tr().language())), "--theme",
                std::string(text(workspace_.theme()))};
    }
    void show_menu_bar();
    void show_dialogs();
    void ask_about_unsaved();
    void copy_picture();
    void quit();
    PictureLook picture_look() const
    {
        return {.background = Theme(workspace_.theme()).background(),
                .title = workspace_.name(),
                .png_scale = workspace_.export_scale};
    }

    Workspace workspace_;
    CommandTable<Workspace> commands_;
    ImGuiSession gui_;
    Context& context_;
    const Fonts& fonts_;
    AppFace face_;
    Dialogs dialogs_;
    UnsavedChanges unsaved_changes_;
    SessionStore session_store_{std::nullopt};
    ThemeName theme_;
    std::optional<LinkedCopy> linked_;
    StartProgram start_program_;
    std::optional<ExportToApp> handed_;
    /// It begins once it is seen that it does: a report of thousands of members takes a while.
    struct AwaitedExport {
        std::filesystem::path path;
        int n_frames = 2; ///< until then: in the first one it is told, and that is seen before the second
    };
    std::optional<AwaitedExport> awaited_export_;
    std::vector<KeyEvent> held_keys_; ///< of commands that wait for a field to give its text to the document
    bool wants_to_quit_ = false;
    bool is_bare_ = false, has_tools_ = true;
    std::optional<Key> commanding_key_; ///< that is held, and no panel's
    bool had_popup_ = false;            ///< in the last frame: Escape, which has closed it since, was for it
};

/// Sessions of documents that another program can have a copy of.
template <class Session>
concept Linkable = requires(Session session, const std::string& text)
{
    session.linked_text();
    session.is_news(text);
    session.adopt(text);
};

/// A tab for each topic of a panel: `topics` are choices.
template <class Workspace, class Topics> void show_topics(Workspace& workspace, const Topics& topics)
{
    TabRow row;
    for (const auto& entry : topics) {
        const std::string title = workspace.tr()(entry.label) + "###" + std::string(entry.id);
        if (row.show(title, entry.value == workspace.topic)) workspace.topic = entry.value;
    }
    ImGui::Separator();
}

template <class Workspace> void DocumentApp<Workspace>::frame(const Input& input)
{
    if (std::exchange(theme_, workspace_.theme()) != workspace_.theme()) gui_.set_theme(Theme(theme_));
    go_on_with_export();
    workspace_.open_dropped(input.dropped_files);
    gui_.begin_frame(input, keeps_panels_still(input));
    handle_keys(input);
    workspace_.tick(input.seconds);
    follow_links(input.seconds);
    if (!is_bare_) show_menu_bar();
    const auto told = foot_message();
    begin_body(told ? height(*told) : is_bare_ ? 0.0F : status_height());
    show_body();
    end_body();
    if (told) {
        if (const auto pressed = show(*told)) answer(*told, *pressed);
    } else if (!is_bare_) {
        show_status();
    }
    show_dialogs();
    handle_requests();
    session_store_.tick(workspace_, logical_size(context_), input.seconds);
    had_popup_ = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    gui_.end_frame();
}

/// Arrows and the space bar are a command's, where it can run, until the key is let go: a panel that the mouse was last
/// in does not move by them. One whose widget is framed, because Tab or a key led there, has them for itself.
template <class Workspace> bool DocumentApp<Workspace>::keeps_panels_still(const Input& input)
{
    for (const KeyEvent& event : input.keys)
        if (!event.is_down && commanding_key_ == event.key) commanding_key_.reset();
    if (had_popup_ || gui_.is_widget_framed()) return commanding_key_.has_value();
    for (const KeyEvent& event : input.keys) {
        const auto* const command = event.is_down && is_of_panel(event.chord()) ? commands_.find(event.chord())
                                                                                : nullptr;
        if (command != nullptr && !why_not(*command, workspace_)) commanding_key_ = event.key;
    }
    return commanding_key_.has_value();
}

template <class Workspace> void DocumentApp<Workspace>::handle_keys(const Input& input)
{
    for (const KeyEvent& event : std::exchange(held_keys_, {})) {
        if (!refuses_text()) run_command_of(event);
        else workspace_.notify(translatable("what is typed cannot be taken; mend it, or give it up with Esc"));
    }
    const bool is_popup_open = had_popup_ || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    const bool is_blocked = dialogs_.wants_keys() || session_store_.is_open() || workspace_.after_question ||
                            is_asking() || is_popup_open;
    if (is_blocked) {
        project_by(input);
        return leave_keys_to_dialog();
    }
    const std::vector<KeyEvent> keys = take_keys(input);
    const bool types = ImGui::GetIO().WantTextInput || is_typing();
    for (const KeyEvent& event : keys) {
        const bool is_escape = event.key == Key::Escape;
        const bool edits_text = ImGui::GetIO().WantTextInput && is_edit_of_text(event.chord()) &&
                                !(is_undo_or_redo(event.chord()) && leaves_undo());
        const bool writes = !is_escape && !event.modifiers.ctrl && !is_function_key(event.key);
        const bool is_for_field = edits_text || (types && writes);
        const bool is_for_panel = is_of_panel(event.chord()) && gui_.is_widget_framed();
        if (!event.is_down || is_for_field || is_for_panel || (is_escape && close_topmost())) continue;
        const auto* const command = commands_.find(event.chord());
        if (types && command != nullptr && command->id.starts_with("file.")) { // saved, or left, with what is typed
            settle_fields();
            held_keys_.push_back(event);
        } else {
            run_command_of(event);
        }
    }
}

template <class Workspace> void DocumentApp<Workspace>::run_command_of(const KeyEvent& event)
{
    const auto* const command = commands_.find(event.chord());
    if (command == nullptr) return;
    const auto reason = run(*command, workspace_);
    ImGui::GetIO().ClearInputCharacters(); // the letter was a command, and none for a field that this opens
    if (!reason) gui_.unframe_widget();    // the next arrow may be that of what this begins
    if (reason && event.key != Key::Escape) workspace_.notify(*reason);
}

template <class Workspace> void DocumentApp<Workspace>::project_by(const Input& input)
{
    for (const KeyEvent& event : input.keys) {
        const auto* const command = event.is_down ? commands_.find(event.chord()) : nullptr;
        if (command != nullptr && command->id == "view.project") run_command_of(event);
    }
}

template <class Workspace> void DocumentApp<Workspace>::handle_requests()
{
    for (const Request request : std::exchange(workspace_.asked, {})) handle_common_request(request);
    for (ExportToApp& exported : std::exchange(workspace_.handed, {})) hand_over(std::move(exported));
    handle_own_requests();
}

template <class Workspace> void DocumentApp<Workspace>::handle_common_request(Request request)
{
    if (dialogs_.handle_request(request, session().path(), session().tr()) || session_store_.handle_request(request))
        return;
    switch (request) {
    case Request::CopyPicture: return copy_picture();
    case Request::Fit: return fit();
    case Request::ZoomIn: return zoom(1.25);
    case Request::ZoomOut: return zoom(0.8);
    case Request::TakeOver:
    case Request::KeepAsItIs: return answer_offer(request);
    case Request::Quit: return quit();
    default: return;
    }
}

template <class Workspace> void DocumentApp<Workspace>::hand_over(ExportToApp exported)
{
    exported.options = common_look();
    handed_ = std::move(exported);
    if (start_program_) start(*handed_);
}

template <class Workspace> void DocumentApp<Workspace>::start(const ExportToApp& exported)
{
    if (const auto reason = start_program(exported)) workspace_.notify(*reason);
}

template <class Workspace> void DocumentApp<Workspace>::handle_file(const ChosenFile& file)
{
    using enum ChosenFile::Purpose;
    switch (file.purpose) {
    case Open: workspace_.open_at_once(file.path); break;
    case Save:
        if (!workspace_.save_as(file.path)) dialogs_.refuse(workspace_.session.notice->sentence);
        break;
    case Export: begin_export(file.path); break;
    }
}

template <class Workspace> void DocumentApp<Workspace>::begin_export(const std::filesystem::path& path)
{
    workspace_.notify({translatable("{file} is being written…"), {{"file", path.filename().string()}}});
    awaited_export_ = AwaitedExport{path};
}

template <class Workspace> void DocumentApp<Workspace>::go_on_with_export()
{
    if (!awaited_export_ || --awaited_export_->n_frames > 0) return;
    const auto reason = export_as(std::exchange(awaited_export_, std::nullopt)->path);
    if (!reason) return;
    workspace_.session.notice.reset();
    dialogs_.refuse(*reason);
}

template <class Workspace> void DocumentApp<Workspace>::quit()
{
    session_store_.end();
    wants_to_quit_ = true;
}

template <class Workspace> void DocumentApp<Workspace>::show_menu_bar()
{
    if (!ImGui::BeginMainMenuBar()) return;
    show_menus(commands_, workspace_, Catalogue(session().tr())); // a command may change the language
    menu_bar_title((session().is_dirty() ? "* " : "") + workspace_.name());
    ImGui::EndMainMenuBar();
}

template <class Workspace> void DocumentApp<Workspace>::link_to(Link link)
{
    if constexpr (Linkable<Session>) linked_.emplace(std::move(link), session().linked_text());
}

template <class Workspace> void DocumentApp<Workspace>::follow_links(double seconds)
{
    if constexpr (Linkable<Session>)
        if (linked_)
            linked_->tick(seconds, {[this] { return session().linked_text(); },
                                    [this](const std::string& other) { return session().is_news(other); }});
    workspace_.offer = "";
    if (linked_ && linked_->offered())
        workspace_.offer = linked_->would_undo_own_change()
                               ? translatable(
                                     "The frame has changed, and so has this: taking over undoes what changed here")
                               : translatable("The frame has changed");
}

template <class Workspace> void DocumentApp<Workspace>::answer_offer(Request request)
{
    if constexpr (Linkable<Session>) {
        if (!linked_ || !linked_->offered()) return;
        if (request == Request::TakeOver) workspace_.session.adopt(linked_->accept());
        else linked_->keep();
    }
}

template <class Workspace> void DocumentApp<Workspace>::show_panels_and_canvas()
{
    const float covered = covered_width();
    if (!workspace_.has_panels) {
        const ImVec2 room = ImGui::GetContentRegionAvail();
        return show_picture({room.x - covered, room.y}, [this] { show_canvas(); });
    }
    const auto panel = [](const char* id, float width, const auto& show) {
        begin_panel(id, width);
        show();
        end_panel();
    };
    face_.sides.show([&](float width) { panel("###left", width, [this] { show_left(); }); },
                     [&](float width) { panel("###right", width, [this] { show_right(); }); },
                     [this] { show_canvas(); }, covered);
}

template <class Workspace>
void DocumentApp<Workspace>::show_panels_and_canvas_above(float height, const std::function<void()>& below)
{
    const ImVec2 room = ImGui::GetContentRegionAvail();
    if (height > 0.0F) show_below(height, below);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, 0U); // the picture is drawn on the theme's own background
    ImGui::BeginChild("###above", {0.0F, room.y - height});
    ImGui::PopStyleColor();
    show_panels_and_canvas();
    ImGui::EndChild();
}

template <class Workspace> std::optional<FootMessage> DocumentApp<Workspace>::foot_message() const
{
    const Catalogue& tr = session().tr();
    constexpr std::size_t most_lines = 10; // a foot of more leaves little of the picture
    if (session().notice)
        return FootMessage{{first_lines(tr(session().notice->sentence), most_lines, tr)},
                           {tr("Close") + "###close notice"}};
    if (workspace_.offer.empty()) return std::nullopt;
    return offer_message(workspace_.offer, tr);
}

template <class Workspace> void DocumentApp<Workspace>::answer(const FootMessage&, std::size_t pressed)
{
    if (session().notice) workspace_.session.notice.reset();
    else workspace_.asked.push_back(answer_of_button(pressed));
}

template <class Workspace> void DocumentApp<Workspace>::show_dialogs()
{
    const Catalogue tr = session().tr(); // a command may change the language
    if (const auto file = dialogs_.show_dialog(tr)) handle_file(*file);
    dialogs_.show_palette_and_keys(commands_, workspace_);
    show_own_dialogs();
    if (bool& is_open = dialogs_.shows_description())
        text_window(tr(face_.description), words(), tr, is_open, [this] { show_beside_words(); });
    session_store_.show(workspace_);
    if (workspace_.after_question) ask_about_unsaved();
}

// What was asked for goes on once the changes are saved or given up.
template <class Workspace> void DocumentApp<Workspace>::ask_about_unsaved()
{
    const auto fate = unsaved_changes_.ask(workspace_.session, dialogs_, session().tr());
    if (!fate) return;
    const auto then = std::exchange(workspace_.after_question, {});
    if (*fate != UnsavedChanges::Fate::Kept) then(workspace_);
}

template <class Workspace> std::optional<Message> DocumentApp<Workspace>::write(const std::filesystem::path& path)
{
    return write_picture(path, picture(), fonts_, picture_look());
}

template <class Workspace> std::optional<Message> DocumentApp<Workspace>::export_as(const std::filesystem::path& path)
{
    const auto reason = write(path);
    context_.make_current(); // a PNG is drawn in a context of its own
    if (!reason) workspace_.notify({written(), {{"file", path.filename().string()}}});
    return reason;
}

template <class Workspace> void DocumentApp<Workspace>::copy_picture()
{
    const auto reason = ui::copy_picture(picture(), fonts_, picture_look());
    context_.make_current(); // it is drawn in a context of its own
    workspace_.notify(reason.value_or(Message(translatable("the picture was copied"))));
}

} // namespace ui
