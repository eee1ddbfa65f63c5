#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "apps/mohr/document/edit.h"
#include "apps/mohr/document/file.h"
#include "apps/mohr/session/drag.h"
#include "apps/mohr/session/practice.h"
#include "ui/workbench/edited_document.h"

namespace mohr {

using ui::Notice;

/// What is open and how it is looked at: the app without its window.
class Session : public ui::EditedDocument<Document> {
public:
    Session();

    const Solution& solution() const { return solution_; }

    /// A step, unless the edit has a fault, or an exercise has the state. \returns why not
    std::optional<ui::Message> apply(Edit edit, const ui::Message& label);
    /// Goes on with a gesture; an edit that `apply` would refuse is passed over.
    void drag(Edit edit, const ui::Message& label);
    void settle() override; ///< ends it
    /// A hand takes hold of what is drawn; then it drags it about, until `settle`.
    void grip(Handle handle, const Drawn& drawn);
    void drag_to(ui::Point at, bool is_fine); ///< \pre it has hold of something
    const std::optional<Grip>& held() const { return grip_; }

    std::optional<ui::Message> set_number(NumberId number, std::string_view text);
    std::optional<ui::Message> set_angle(double degrees);
    std::optional<ui::Message> set_normal(const std::array<double, 3>& normal);
    std::optional<ui::Message> set_principal(double first, double second, double degrees);
    /// In space: the principal values, or one direction (0, 1, 2), the others turning along.
    std::optional<ui::Message> set_principal(const std::array<double, 3>& values);
    std::optional<ui::Message> set_direction(int direction, const std::array<double, 3>& along);
    void set_gauges(const std::array<double, 3>& degrees); ///< the directions of a rosette's
    void set_subject(Subject subject);
    void set_criterion(std::optional<femoop::mohr::Criterion> criterion);
    /// Changes how the shear is drawn.
    void set_rule(femoop::mohr::ShearRule rule);

    /// Shows the exercise's state in place of the document, as one step; what would tell an answer is hidden until it
    /// is finished. It has the state until `end_exercise`, or until another file is opened: neither an edit nor a step
    /// back changes it.
    void begin_exercise(ExerciseTopic topic, Difficulty difficulty, std::uint32_t seed);
    const std::optional<Practice>& practice() const { return practice_; }
    /// \returns why the words are no answer
    std::optional<ui::Message> answer(std::size_t place, std::string_view words);
    void give_up_exercise();
    void end_exercise() { practice_.reset(); }
    bool is_concealing() const { return practice_ && !practice_->is_finished(); }
    std::string_view why_state_stays() const; ///< \pre there is an exercise, which has the state

    void new_document();
    /// A frame that has handed over a section goes on with it in its own window (ui/files/linked_copy.h): it is told
    /// the section, and tells section, N, V, M and material.
    std::string linked_text() const { return file_text_of_section(document()); }
    bool is_news(const std::string& text) const; ///< taking it over would change the document
    void adopt(const std::string& text);         ///< as a step; the notice tells why not

    /// Time goes by.
    void tick(double seconds);
    bool is_moving() const { return is_playing || path_time_ || notice.has_value(); }
    bool is_playing = false; ///< the plane turns by itself

    void record_path_state(); ///< the present state becomes the path's next one
    void clear_path();
    void play_path(); ///< the state goes along the path, from its beginning; one step of the history

    /// The steps of the construction, where it is shown; the circle as a whole otherwise.
    const std::optional<std::size_t>& step() const { return step_; }
    std::size_t n_steps() const;                             ///< of the state's construction
    void show_construction(std::optional<std::size_t> step); ///< from 1; taken into the range

    Look look;
    ui::OrbitCamera eye;
    std::optional<Handle> hover;
    const ui::Catalogue& tr() const override { return look.tr; }

    Scene scene() const;

private:
    std::optional<Notice> read(const std::filesystem::path& path) override;
    std::string file_text() const override { return mohr::file_text(document()); }
    std::string about(const ui::Catalogue& tr) const override;
    Frame frame() const; ///< of what is drawn now
    void prepare_to_go() override { path_time_.reset(); }
    std::optional<ui::Message> why_not_here() const override;
    void follow(const Document& /*before*/) override { solve_again(); }
    bool would_leave_exercise(const Document& next) const;
    void solve_again();
    void follow_path(double seconds);
    void restart(Document document);

    Solution solution_;
    std::optional<std::size_t> step_;
    std::optional<Practice> practice_;
    std::optional<double> path_time_; ///< 0 to 1, while the path is played
    std::optional<Grip> grip_;
};

} // namespace mohr
