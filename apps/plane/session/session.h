#pragma once

#include <cstddef>
#include <filesystem>
#include <future>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/plane/document/analysed.h"
#include "apps/plane/document/analysis_run.h"
#include "apps/plane/document/change.h"
#include "apps/plane/document/outlines.h"
#include "apps/plane/document/part.h"
#include "apps/plane/document/solution.h"
#include "apps/plane/document/vibration.h"
#include "apps/plane/session/look.h"
#include "apps/plane/session/mesher_watch.h"
#include "ui/canvas/plane_camera.h"
#include "ui/text/display_units.h"
#include "ui/workbench/edited_document.h"

namespace plane {

/// How long results are waited for [s].
struct Patience {
    double of_a_hand = 0.05;    ///< what takes longer is not waited for while one drags
    double behind_a_hand = 0.5; ///< what takes longer does not follow one
    double at_most = 20.0;      ///< then it is given up, where nobody could do so
    /// Results are waited for in a frame; from then on frames are drawn while they are found, and say so.
    double in_a_frame = std::numeric_limits<double>::infinity();
    std::size_t most_unknowns = std::numeric_limits<std::size_t>::max(); ///< that are solved for without a question
    static Patience of_a_window() { return {.in_a_frame = 0.3, .most_unknowns = 400'000}; }
};

/// What is open and how it is looked at: the app without its window. The document changes through `change` alone; its
/// solution follows, and the regions go with their faces.
class Session : public ui::EditedDocument<Document> {
public:
    explicit Session(const Document& document = plane::new_document());

    const PlaneModel& model() const { return document().model; }
    const Solution& solution() const { return *solution_; }
    std::shared_ptr<const Solution> kept_solution() const { return solution_; } ///< while the document changes
    const discretize::Drawing* drawing() const { return solution_->drawing(); }

    /// Carries it out. Where the document would get a fault by it that no drawing may have, such as a thickness below 0
    /// or an arc through places in one line, nothing is changed. \returns why not, for the notice too
    std::optional<ui::Message> change(const Change& change);
    void settle() override;
    void cancel(); ///< takes back the gesture that is under way

    std::size_t opening() const { return opening_; } ///< counts the documents that were opened
    void new_document();
    /// The curves of a DXF or SVG file join the drawing, as a step that can be taken back; a notice tells what of the file
    /// is left out. False, with a notice, where it cannot be read or has no curves; then nothing changes.
    bool insert_outline(const std::filesystem::path& path);
    /// The PNG or JPEG image of a file lies behind the drawing, in place of the one that was there, as a step that can be
    /// taken back. False, with a notice, where it cannot be read; then nothing changes.
    bool insert_backdrop(const std::filesystem::path& path);
    void show_example(Document document); ///< as a document without a file

    std::string name() const override; ///< without a file the model's title
    ui::UnsavedDocument unsaved() const override;
    ui::DisplayUnits units() const;
    const ui::Catalogue& tr() const override { return look.tr; }
    PlateInput input() const; ///< of one drawing, that of `analysed` where there is one
    PlateOptions options() const { return options_of(look, load_case); }

    // ---- mesh and results

    /// Finds the mesh and the results where they are shown and the drawing has changed. While a hand drags, only where
    /// they came fast enough to follow it.
    void analyse_what_is_shown();
    /// Of the drawing as it is now; while a mesh goes along with a hand, as it was some frames before. Null where they are
    /// not shown, or not found.
    const Analysed* analysed() const;
    /// Why what is shown has no mesh or no results; nothing where it has, or none is wanted.
    std::optional<ui::Message> why_no_results() const;

    /// The analysis of the drawing that is under way while frames are drawn; null: none.
    const AnalysisRun* run() const { return run_ && run_->solution() == solution_ ? run_.get() : nullptr; }
    void give_up_analysis(); ///< that one
    /// Whether it was given up, or not begun because it has too many unknowns.
    bool was_left() const;
    void analyse_all_the_same(); ///< \pre it was left

    /// Of the mesh as it is now; null where modes are not shown, or there are none.
    const femoop::plane::NaturalModes* modes() const;
    std::vector<femoop::Fault> faults_of_modes() const; ///< why there are none, or what is to be said of them

    /// The range of the bands as they are now; nothing where there are none.
    std::optional<KeptRange> range_of_bands() const;

    // ---- refinement by the error

    /// Refines the mesh by the estimated error of the case that is shown, so many times: one mesh after the other as time
    /// goes on, each a step that can be taken back. What is not shown yet is shown. \returns why not
    std::optional<ui::Message> refine(std::size_t n_cycles);
    void stop_refining() { refinement_.reset(); }
    bool is_refining() const { return refinement_.has_value(); }
    std::size_t n_refinements_left() const { return refinement_ ? refinement_->n_left : 0; }
    const discretize::ErrorCycle* cycle() const { return document().cycle.get(); } ///< null: the mesh is not refined
    void give_up_refinement(); ///< the mesh is as the drawing says again; a step that can be taken back

    // ---- comparing

    /// The results that are shown stay behind those that follow, of this drawing or of another mesh. \returns why not
    std::optional<ui::Message> keep_results();
    void forget_results() { kept_.reset(); }
    bool has_kept_results() const { return kept_ != nullptr; }

    // ---- how the mesh comes to be

    /// Shows the first step of its making. \returns why there is none to be watched
    std::optional<ui::Message> watch_mesher();
    /// Of the drawing as it is now; null where it is not watched.
    const discretize::MeshPlayer* player() const { return watch.of(solution_); }

    // ---- what is selected

    const std::vector<Part>& selection() const { return selection_; }
    void select(const Part& part) { selection_ = {part}; }
    void toggle(const Part& part); ///< into the selection, or out of it
    void select_nothing() { selection_.clear(); }
    bool is_selected(const Part& part) const;
    /// The face of the drawing that a place is in.
    std::optional<std::size_t> face_of(const FacePlace& place) const;
    std::optional<RegionId> region_of(const Part& part) const; ///< of a face that has one
    /// The region of a selected face, where only that is selected.
    std::optional<RegionId> selected_region() const;
    std::vector<RegionId> selected_regions() const; ///< of faces; none where anything without a region is selected too
    PlateHighlight highlight(const std::vector<Part>& parts) const;

    // ---- what is told of the drawing as a whole

    /// The gap to be told: none while it was said that it stays.
    std::optional<Gap> gap() const;
    void leave_gap();

    void tick(double seconds);
    bool is_moving() const
    {
        return notice.has_value() || is_swinging() || watch.is_playing() || is_refining() || run();
    }
    /// Share of the displacements that is drawn, -1 to 1; 1 where nothing swings.
    double phase() const;

    Look look;
    MesherWatch watch;
    Patience patience{};
    std::size_t load_case = 0;               ///< that is shown
    std::optional<ui::PlaneCamera> camera{}; ///< where the view was moved by hand; else everything is shown
    std::optional<Part> hover{};
    bool is_still = false;    ///< modes and mechanisms swing only where they are animated
    bool is_animated = false; ///< the deformed shape swings

private:
    std::string told(const std::vector<femoop::Fault>& faults) const;
    bool is_swinging() const;      ///< that, or what can move without strain
    std::size_t mechanism() const; ///< that is drawn: each for some swings
    std::optional<ui::Notice> read(const std::filesystem::path& path) override;
    std::optional<ui::Notice> read_draft(const std::filesystem::path& path) override { return read(path); }
    std::string file_text() const override;
    std::string about(const ui::Catalogue& tr) const override;
    void follow(const Document& before) override;
    Written write_file(const std::filesystem::path& path) override;
    bool is_same(const Document& a, const Document& b) const override
    {
        return a.model == b.model && a.backdrop == b.backdrop;
    }
    /// A notice tells that the file was not opened, and why. \returns false
    template <class Reason> bool refuse(const std::filesystem::path& path, const Reason& reason);
    std::vector<ui::Message> sentences_of(const std::vector<femoop::Fault>& faults) const;
    void refine_further(double seconds);
    std::optional<ui::Message> refine_once(); ///< \returns why the cycle ends here
    void solve_again();
    void keep_beside(PlateInput& input) const;
    void accept(std::shared_ptr<const Solution> solution); ///< of the document
    void keep_selection(const PlaneModel& before);
    void restart(Document document);
    void find_mesh_and_results();
    void find_anew();
    void drop_run();
    /// Does the mesh of before go along with the hand?
    bool follow_with_mesh();
    bool follows_slower_than(double seconds) const { return follow_seconds_ && *follow_seconds_ > seconds; }
    void stop_following();
    void find_modes();
    /// The solution of the document that a change starts from.
    const Solution& settled() const { return history_.is_dragging() && settled_ ? *settled_ : *solution_; }

    std::shared_ptr<const Solution> solution_, settled_; ///< settled_: before the gesture that is under way
    std::shared_ptr<const Analysed> analysed_;
    std::shared_ptr<const Analysed> kept_;    ///< to be compared with
    std::shared_ptr<const Analysed> dragged_; ///< of before the drag that is under way
    std::shared_ptr<Following> following_;    ///< along with dragged_
    /// What another thread makes while frames are drawn; the one that finds it ready takes it.
    struct Ahead {
        std::shared_ptr<const Analysed> analysed;
        double seconds = 0.0; ///< that it took
    };
    std::shared_future<Ahead> ahead_;
    std::shared_ptr<AnalysisRun> run_;                 ///< of the drawing as it is, or as it was
    std::vector<std::shared_ptr<AnalysisRun>> ending_; ///< given up
    std::shared_ptr<const Solution> insisted_;         ///< is solved however many unknowns it has
    std::shared_ptr<const Vibration> vibration_;
    double swing_ = 0.0;                   ///< since it began, at the largest displacement [s]
    double last_seconds_ = 0.0;            ///< that an analysis took
    double modes_seconds_ = 0.0;           ///< that finding the modes took
    std::optional<double> follow_seconds_; ///< that the fastest one of this drag took, with the mesh that went along
    struct Refinement {
        std::size_t n_left = 0; ///< meshes
        double waited = 0.0;    ///< since the last one was made [s]
    };
    std::optional<Refinement> refinement_;
    std::vector<Part> selection_;
    std::optional<Gap> gap_, left_gap_;
    std::size_t opening_ = 0;
};

/// "line", "arc": what a curve is, to be translated.
std::string_view word_of(femoop::plane::DrawnKind kind);
/// "Traction", "Body force": what a load is, to be translated.
std::string_view word_of(const femoop::plane::CurveLoad& load);
std::string_view word_of(const femoop::plane::RegionLoad& load);
/// Points, curves, regions, cases and faults in words.
std::string description(const Session& session);
/// The line at the window's foot.
std::string status_text(const Session& session);

} // namespace plane
