#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/euler/document/palette/pending_operator.h"
#include "apps/euler/document/snapshot.h"
#include "apps/euler/document/stepper.h"
#include "apps/euler/session/challenge/game.h"
#include "apps/euler/view/look.h"
#include "apps/euler/view/subject.h"
#include "ui/canvas/orbit_camera.h"
#include "ui/canvas/plane_camera.h"
#include "ui/workbench/open_document.h"

namespace euler {

using ui::Notice;

bool lives(const topology::Solid& solid, topology::Entity entity);

/// How the topology is drawn.
enum class ViewKind : std::uint8_t {
    Space,    ///< where the vertices are
    Plane,    ///< as a map in the plane, one face outside all others
    Polygons, ///< each loop a polygon, edges told by colour: the plane model
};

/// One of the two pictures of "Which operator was applied?"
enum class Side : std::uint8_t { Before, After };

/// What is open and how it is looked at: the app without its window. A script with a fault is opened up to that, with
/// its text, where `faulty_line` is to be mended.
class Session : public ui::OpenDocument<Stepper::Script> {
public:
    Session();

    const Stepper& stepper() const { return stepper_; }
    std::size_t place() const { return stepper_.place(); }
    std::size_t n_steps() const { return stepper_.n_steps(); }

    /// An empty script.
    void new_document();
    /// A lesson that comes from no file of the user's, shown before its first step.
    void show(Stepper lesson);
    ui::UnsavedDocument unsaved() const override; ///< without writing the script out
    bool is_dirty() const override { return is_dirty_ || is_text_changed(); }

    /// At once.   \pre place <= n_steps()
    void go_to(std::size_t place);
    /// One step, which is seen on its way. \pre there is one
    void step_forward();
    void step_back();
    /// Time goes by. \returns whether something moved
    bool tick(double seconds);
    bool is_moving() const { return motion_.has_value() || is_playing; }
    bool is_playing = false; ///< one step follows the other
    bool is_still = false;   ///< a step is done at once
    double speed = 1.0;      ///< of what moves
    static constexpr double slowest = 0.25, fastest = 4.0;

    /// The step that is looked at: the one done last, or the one that is being taken back. 0 before the first.
    std::size_t step() const { return place() + (motion_ && motion_->is_back ? 1 : 0); }
    const StepReport* report() const { return report_ ? &*report_ : nullptr; } ///< of that step; null before the first
    /// Counts what was looked at: what is derived from one place is stale when it has grown.
    std::uint64_t generation() const { return generation_; }
    /// The solids before and after that step, in the order of the runner's.
    const std::vector<Snapshot>& before() const { return before_; }
    const std::vector<Snapshot>& after() const { return after_; }
    /// Where the lesson stands, also while a step is seen being taken back.
    const std::vector<Snapshot>& present() const { return motion_ && motion_->is_back ? before_ : after_; }
    const std::vector<Snapshot>& at_end() const { return at_end_; } ///< of the lesson
    /// What the picture shows: the solids, the step on its way, what is selected, what an operator asks for.
    std::vector<Subject> subjects() const;
    /// Those of `subjects`.
    const std::vector<Snapshot>& shown() const;

    /// A step on its way: the solids at its other end, and how much of the way those that are shown have before them or
    /// behind them: 1 where they are at home.
    struct Transition {
        const std::vector<Snapshot>& other;
        double share;
    };
    std::optional<Transition> transition() const;

    /// Begins to ask for an operator's arguments.
    void begin(Verb verb);
    const std::optional<PendingOperator>& draft() const { return pending_operator_; }
    /// The next argument. \returns why it cannot be that
    std::optional<ui::Message> choose(const Choice& choice);
    /// The next argument, as it is typed. \returns why it cannot be that
    std::optional<ui::Message> choose_typed(std::string_view text);
    /// What lies under the pointer as an argument, and why not.
    std::optional<ui::Message> why_not_pick(const Part& part) const;
    void pick(const Part& part); ///< selects it, or gives it to the operator that asks
    void undo_choice();          ///< the last one; without one the operator is given up
    void cancel_operator();
    void open_sweep();                                       ///< into its MEV and MEF \pre it is the last step done
    bool has_just_opened_sweep() const;                      ///< a step back makes it one step again
    bool accept();                                           ///< does what the operator would do
    std::optional<ui::Message> apply(std::string_view line); ///< one more line. \returns why not, nothing being changed

    /// Applies a line that is written at this place of the script; `script_fault` says why it cannot be done.
    bool write(std::string_view line);
    /// The script is edited as a whole: `edited_text` takes the place of its steps.
    std::optional<ui::Message> why_not_edit_text() const;
    void edit_text();
    /// Runs the text in place of the script; else `script_fault` names the line, and nothing is changed.
    bool accept_text();                      ///< \pre it is edited
    void cancel_text();                      ///< the text comes back when the same script is edited next
    std::optional<std::string> edited_text;  ///< while it is edited
    std::optional<std::size_t> faulty_line;  ///< of the text, from 1, where it could not be run
    bool is_fault_new = false;               ///< the line is to be brought into sight
    std::optional<ui::Message> script_fault; ///< of what was written last; nothing once something was done
    static constexpr std::size_t most_letters_of_text = 100'000, most_letters_of_line = 1000; ///< to be edited

    /// Draws a straight line into the plane figure that was worked on last, and tells which operators it takes and why
    /// these. \returns why it cannot be drawn
    std::optional<ui::Message> draw(const topology::Point& from, const topology::Point& to);
    /// Lines are drawn on the xy plane, seen from the top.
    bool is_drawing() const { return is_drawing_; }
    void draw_or_look(); ///< begins to draw lines, or ends it

    /// Begins a challenge in place of the lesson. It ends with the next lesson that is opened.
    void play(Game game);
    const std::optional<Game>& game() const { return game_; }
    std::string& typed_answer() { return game_->typed; }       ///< \pre there is a challenge, likewise below
    void give_hint() { game_->give_hint(stepper_); }           ///< \pre there is one
    std::optional<ui::Message> answer(std::string_view words); ///< \returns why it is no answer
    void give_up_challenge();                                  ///< shows one way to a solid that was to be reached
    void show_side(Side side);                                 ///< \pre two pictures are compared
    Side side() const { return side_; }
    bool is_exhibiting() const; ///< a challenge shows solids that no script has made
    int points() const { return earned_ + (game_ ? game_->points() : 0); } ///< of all challenges so far

    std::optional<Part> selection, hover;
    Look look;
    ViewKind view() const { return view_; }
    void show_as(ViewKind kind);
    void look_from_corner();      ///< so that no vertex covers another
    ui::OrbitCamera eye, map_eye; ///< in space, and on the map in the plane
    ui::PlaneCamera polygon_eye;  ///< on the plane model
    bool is_fitted = true;        ///< the camera shows everything, until it is moved by hand
    const ui::Catalogue& tr() const override { return look.tr; }

private:
    std::optional<Notice> read(const std::filesystem::path& path) override;
    const Stepper::Script& current() const override { return whole_; }
    std::string file_text() const override { return whole_.text(); }
    void settle() override;
    Written write_file(const std::filesystem::path& path) override;
    bool is_text_changed() const { return edited_text && *edited_text != text_before_; }
    std::string about(const ui::Catalogue& tr) const override;
    void note_saved() override { is_dirty_ = differs_from_saved(); }

    struct GivenUpText {
        std::string script; ///< in place of which it stood
        std::string text;
    };
    struct Motion {
        bool is_back;
        double done = 0.0; ///< 0 to 1
    };
    /// The lesson before a sweep was opened, and where it stood afterwards.
    struct Opening {
        Stepper closed;
        std::uint64_t n_changes;
        std::size_t place;
    };
    void close_sweep();
    double progress() const; ///< of the step on its way, 0 to 1 \pre there is one
    void forget_passing_notice();
    void look_at_place();
    void move(bool is_back); ///< the step that was taken is seen on its way
    void look_at_end();
    void restart(Stepper lesson);
    void show_fault(const std::filesystem::path& path, const std::string& text, const topology::LineError& fault);
    void notify_fault(const topology::LineError& fault);
    void look_again();
    void look_clearly();
    void note_change();
    void fill_in_suggestions();
    void exhibit();
    void preview_pending_operator();

    ViewKind view_ = ViewKind::Space;
    bool is_drawing_ = false;
    std::optional<Game> game_;
    Side side_ = Side::Before;
    int earned_ = 0; ///< points of challenges that have gone
    Stepper stepper_;
    Stepper::Script whole_;   ///< the stepper's, to be saved
    bool is_dirty_ = false;   ///< kept, since a script can have a million steps
    std::string text_before_; ///< that is edited, as it was
    std::optional<GivenUpText> given_up_;
    std::uint64_t n_changes_ = 0; ///< of the script
    std::optional<Opening> opening_;
    std::vector<Snapshot> before_, after_, at_end_;
    std::optional<StepReport> report_;
    std::optional<Motion> motion_;
    std::uint64_t generation_ = 0;
    double rest_ = 0.0; ///< since the last step, while playing [s]
    std::optional<PendingOperator> pending_operator_;
    std::vector<topology::Entity> legal_;        ///< picks for the argument that is asked for
    std::vector<Snapshot> preview_;              ///< as they would be; empty where nothing is ready
    std::vector<topology::Entity> preview_made_; ///< by the operator
    std::size_t preview_solid_ = 0;
};

} // namespace euler
