#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "apps/cross/document/document.h"
#include "apps/cross/document/solution.h"
#include "apps/cross/view/scene.h"
#include "apps/cross/view/worksheet.h"
#include "ui/text/message.h"
#include "ui/workbench/edited_document.h"

namespace cross {

using ui::Notice;

/// What a click on a member adds.
enum class Tool : std::uint8_t { None, UniformLoad, PointLoad };

/// What is open, how far it is worked and how it is looked at: the app without its window.
class Session : public ui::EditedDocument<Document> {
public:
    Session();

    const Solution& solution() const { return solution_; }
    const femoop::cross::Sheet* sheet() const { return solution_.sheet(document()); }
    const TurnTree* turn_tree()
        const; ///< of the sheet that is worked on; null where nothing was done, or all are together

    /// Releases and balances a joint, or all joints at once. \returns why not
    std::optional<ui::Message> balance(const TurnTree::Turn& clicked);
    std::optional<ui::Message> step(); ///< on the way that was gone before, else whose turn it is by the method's order
    std::optional<ui::Message> back();
    void restart();
    void jump(std::size_t n_turns);
    std::optional<ui::Message> finish(); ///< until no unbalance is larger than the tolerance
    void go_to_branch(std::size_t place);
    std::optional<ui::Message> why_no_turn() const;
    std::optional<ui::Message> why_no_step() const;

    void set_method(const Method& method, const ui::Message& label);
    void set_stage(std::size_t stage);
    std::size_t n_stages() const; ///< sheets, and with sways all of them together
    /// Changes the structure or its loads; while a hand drags, as one step.
    void change(femoop::Model model, const ui::Message& label);
    void drag(femoop::Model model, const ui::Message& label);
    void settle() override;
    /// Unless it is dropped, or something else is changed, within the time of a double click.
    void change_later(femoop::Model model, const ui::Message& label);
    void change_at_once(); ///< what waits, if anything does
    void drop_waiting() { waiting_.reset(); }

    // ---- a pupil fills the sheet (pupil.cpp)

    void begin_exercise(const Seeded& seeded);
    void begin_own_exercise(); ///< on the structure that is open
    void end_exercise();
    /// Null where no pupil fills the sheet.
    const Worksheet* worksheet() const { return worksheet_ ? &*worksheet_ : nullptr; }
    bool hides_results() const { return worksheet() != nullptr && !worksheet()->is_solved(); }
    std::optional<ui::Message> why_no_worksheet() const;
    std::optional<ui::Message> why_no_own_exercise() const;
    std::optional<femoop::cross::BlankId> cell() const { return cell_; } ///< that is being filled
    void go_to_cell(std::optional<femoop::cross::BlankId> cell);
    /// The cell after this one, or before it; nothing at the end. \param only_open  one that is not good yet
    std::optional<femoop::cross::BlankId> neighbour(int step, bool only_open) const;
    /// \returns why not; "" leaves the cell empty
    std::optional<ui::Message> write(femoop::cross::BlankId cell, const std::string& text);
    void show_cell();                               ///< what belongs into the present one
    void give_hint();                               ///< one more for the present cell
    std::vector<femoop::cross::Hint> hints() const; ///< that were given for it
    void start_over();
    void judge_at_once(bool does);
    void judge_now();
    std::size_t worksheet_stage() const { return worksheet_stage_; }
    void show_worksheet_stage(std::size_t stage);
    std::size_t points() const; ///< cells that were right without help, the first time

    void new_document();
    /// A frame that has handed over its structure goes on with it in its own window (ui/files/linked_copy.h).
    std::string linked_text() const;
    bool is_news(const std::string& text) const; ///< taking it over would change the structure
    void adopt(const std::string& text);         ///< the structure, as a step; the notice tells why not

    /// Another number whenever nodes, joints and cells may be others than before.
    std::size_t n_solved() const { return n_solved_; }
    void tick(double seconds); ///< time goes by
    bool is_moving() const { return is_playing || phase_ < 1.0 || waiting_ || notice.has_value(); }
    bool is_playing = false; ///< turn after turn by itself
    bool is_still = false;   ///< a turn is done at once
    Tool tool = Tool::None;
    double phase() const { return is_still ? 1.0 : phase_; }

    Look look;
    std::optional<femoop::cross::JointId> hover;
    const ui::Catalogue& tr() const override { return look.tr; }

    Scene scene() const;

private:
    std::optional<Notice> read(const std::filesystem::path& path) override;
    std::string file_text() const override; ///< the score goes with it
    std::string about(const ui::Catalogue& tr) const override;
    void prepare_to_go() override { change_at_once(); }
    /// An exercise whose solution was not seen yet is left by its own command alone.
    std::optional<ui::Message> why_not_here() const override;
    void follow(const Document& before) override;
    bool is_same(const Document& a, const Document& b) const override { return is_same_task(a, b); }
    void solve_again(SolveMode mode = SolveMode::Full);
    void work_again(); ///< the sheets alone
    void find_state();
    void show_solved();          ///< of a sheet that is right
    void judge_worksheet();      ///< after the document changed
    void leave_unfit_exercise(); ///< of a file whose structure has no such sheet
    void change_pupil(Pupil pupil, const ui::Message& label);
    void note_mistakes();
    void note_all_seen();
    bool refuse_in_exercise(); ///< true, with a notice, while a pupil fills the sheet
    void restart_with(Document document);
    template <class Change> void play_on(const Change& change, const ui::Message& label);
    void advance(const TurnTree::Turn& turn);

    struct WaitingChange {
        femoop::Model model;
        ui::Message label;
        double seconds_left;
    };

    std::optional<WaitingChange> waiting_;
    Solution solution_;
    std::optional<femoop::Results> state_;
    std::shared_ptr<femoop::cross::StateAnalysis> states_; ///< of the solution's structure; null before the first
    double phase_ = 1.0;
    std::size_t n_solved_ = 0;
    std::optional<Worksheet> worksheet_;
    std::optional<femoop::cross::BlankId> cell_;
    std::size_t worksheet_stage_ = 0;
    /// What a pupil was told of every cell: undoing does not forget it.
    struct ShownTurn {
        std::vector<std::size_t> n_hints;
        std::vector<bool> helped;
        bool is_solution_seen = false; ///< it was left, or solved
    };
    std::vector<ShownTurn> seen_; ///< of every exercise on what is open, by Pupil::number
    std::size_t present_ = 0;     ///< the exercise of the paper
};

} // namespace cross
