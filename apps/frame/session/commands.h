#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/frame/session/bottom_view.h"
#include "apps/frame/session/derivation_show.h"
#include "apps/frame/session/design_draft.h"
#include "apps/frame/session/distribution_check.h"
#include "apps/frame/session/pointed_number.h"
#include "apps/frame/session/section_draft.h"
#include "apps/frame/session/session.h"
#include "apps/frame/session/solver_show.h"
#include "apps/frame/session/train_draft.h"
#include "apps/frame/session/transform.h"
#include "apps/frame/session/typical_draft.h"
#include "apps/frame/tools/tool_controller.h"
#include "ui/command/menu_builder.h"
#include "ui/files/autosave.h"
#include "ui/workspace/workspace.h"

namespace frame {

/// What the user asks this app's window for, beside what every app's is asked for.
enum class Request : std::uint8_t {
    ImportDialog,
    KeepView,
    ViewList,
    UnitWindow,
    ExportTable,
    AskKind,        ///< of the structure that was begun
    EditTitle,      ///< of the model
    RenameCase,     ///< the name of the case that is shown is typed in the list of cases
    ContextMenu,    ///< of what is selected
    CopyDerivation, ///< of the number that is explained, as text
    CopyDerivationAsLatex
};

/// What the panel at the right shows.
enum class Topic : std::uint8_t { Properties, Results, Problems, History };

/// The document of the tab that is shown, the panels around its picture, and what its commands ask the window for. The
/// window takes the requests once a frame.
struct Workspace : ui::Workspace {
    explicit Workspace(Session first);
    ui::ThemeName& theme() { return session.view.theme; }
    ui::ThemeName theme() const { return session.view.theme; }
    const ui::Catalogue& tr() const { return session.view.tr; }
    std::optional<ui::UnitSystem> units() const { return session.view.units; }
    const ui::UnitChoices& unit_choices() const { return session.view.unit_choices; }
    void set_language(ui::Language language) { session.set_language(language); }
    std::string kept_tools() const;
    void take_up_tools(std::string_view words);
    std::string name() const;
    void notify(const ui::Message& sentence) { session.notify(sentence); }
    void tick(double seconds);
    bool is_moving() const;
    bool has_open_draft() const; ///< something is made in a window over the panel at the right
    void open(const std::filesystem::path& path) { open_at_once(path); } ///< nothing is lost by a further tab
    void open_dropped(const std::vector<std::string>& files);
    bool open_at_once(const std::filesystem::path& path); ///< as `open_file` (tabs.h)
    bool save_as(const std::filesystem::path& path);      ///< unless another tab shows that file; then with a notice
    /// Asks about each document that is not saved in its own tab, and closes those that are given up.
    void leave_all(std::function<void(Workspace&)> then);
    std::vector<ui::UnsavedDocument> unsaved() const;
    bool can_recover() const { return !session.history().is_dragging(); }
    std::optional<std::uint64_t> recover(const ui::RecoverableFile& recoverable); ///< in a tab of its own

    Session session;
    ToolController tool_controller{};
    std::function<void(Workspace&)> after_question{};
    std::vector<Session> other_tabs{};           ///< the other tabs in their order (tabs.h)
    std::size_t tab = 0;                         ///< place of the session among the tabs
    std::shared_ptr<const Clipping> clipboard{}; ///< what was copied last; null before that
    std::optional<Transform> transform{};        ///< under way: its numbers can still change
    TypicalDraft typical{};
    SectionDraft section{};
    DesignDraft design{};
    TrainDraft trains{};
    std::vector<Request> requests{};
    std::optional<Cut> menu_cut{};                 ///< where the context menu was asked for, on a member
    std::optional<PointedNumber> menu_number{};    ///< on which number of the results it was asked for
    std::optional<PointedNumber> pointed_number{}; ///< under the pointer, in the picture or in a table
    std::optional<NamedEffect> asked_number{};     ///< that W or Shift+W was pressed at, until the pointer moves
    Topic topic = Topic::Properties;
    BottomView bottom{};
    SolverShow solver{};                             ///< what the panel at the bottom shows of it
    DerivationShow derivation{};                     ///< likewise of the number that is explained
    std::optional<RefusedRelease> refused_release{}; ///< whose motion the picture shows until something else is asked
    DistributionCheck distribution{};

private:
    double swing_; ///< the animation's time since the middle of a swing [s]
};

using CommandTable = ui::CommandTable<Workspace>;

/// Everything that the app can do, by name.
CommandTable command_table();

using Menu = ui::MenuBuilder<Workspace>;
/// To influence lines, free bodies, a truss by hand, "why?".
inline constexpr std::string_view methods_menu = ui::translatable("Methods");

/// The commands that choose what the panel at the right shows, in the order of its tabs.
using TopicEntry = ui::Choice<Topic>;
std::span<const TopicEntry> topics();

/// The word that a scenario and a menu use for each thing that the picture can show: "view.show.loads".
std::string_view command_id(Show item);

} // namespace frame
