#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/drawing/cut.h"
#include "apps/drawing/draw_input.h"
#include "apps/drawing/draw_options.h"
#include "apps/drawing/draw_state.h"
#include "apps/drawing/pick.h"
#include "apps/frame/document/change.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/document/selection.h"
#include "apps/frame/document/solution.h"
#include "apps/frame/free_body/asked_body.h"
#include "apps/frame/funicular/asked_funicular.h"
#include "apps/frame/influence/asked_envelope.h"
#include "apps/frame/influence/asked_line.h"
#include "apps/frame/predict/prediction.h"
#include "apps/frame/session/kept_counting.h"
#include "apps/frame/tables/table.h"
#include "apps/frame/truss/asked_truss.h"
#include "apps/frame/virtual_work/asked_work.h"
#include "femoop/model/fault/fault.h"
#include "ui/text/display_units.h"
#include "ui/text/message.h"
#include "ui/text/notice.h"
#include "ui/workbench/edited_document.h"

namespace frame {

/// Something that the app tells its user: one sentence, and the faults that it is about.
struct Notice : ui::Notice {
    std::vector<femoop::Fault> faults{};
    /// A file that was understood, but whose structure has errors: it can be opened to be mended.
    std::optional<std::filesystem::path> to_mend{};
    bool is_about_model = false; ///< the faults lie in the model that is open: a click on one goes there
};

/// What stays until it is closed, about the model that is open.
Notice about_model(ui::Message sentence, std::vector<femoop::Fault> faults);
/// A change was not made, since the model that is open would get these faults.
Notice refusal_of(std::vector<femoop::Fault> faults);

/// What is open and how it is looked at: the app without its window. The document changes through `change` alone; its
/// solution follows.
class Session : public ui::EditedDocument<Document, Notice> {
public:
    explicit Session(Document document);

    const femoop::Model& model() const { return document().model; }
    const Solution& solution() const { return solution_; }
    /// Counts the solutions: what is derived from one is stale when it has grown.
    std::uint64_t generation() const { return generation_; }
    /// Tells the sessions of one program apart.
    std::uint64_t number() const { return number_; }

    /// Carries it out, or throws what its command throws and changes nothing. Where it takes a node too far off
    /// (document/reach.h) nothing is changed, `notice` says why, and so does what is returned.
    std::optional<ui::Message> change(const Change& change);
    /// Carries it out where the model gets no error by it that it had not and no node goes too far off; else nothing,
    /// and `notice` says why.
    bool change_soundly(const Change& change);
    void settle() override;
    void cancel();
    /// What it speaks of is over: undone, or done with another tool. What is wrong with a file stays told.
    void forget_notice();

    /// `Mend` opens a file too that is understood but whose structure has errors, as one that was saved while it was
    /// drawn. What stands beside the model comes from its companion file; what is wrong with that hinders nothing, and
    /// `notice` tells it. Saving writes both; a companion file with faults is kept under another name, with a notice.
    enum class Purpose : std::uint8_t { Work, Mend };
    bool open(const std::filesystem::path& path, Purpose purpose = Purpose::Work)
    {
        return note_opened(path, read(path, purpose));
    }
    /// Tells that a file was not opened.
    void refuse(const std::filesystem::path& path, const Notice& reason);
    std::string name() const override; ///< without a file the model's title
    bool is_dirty() const override { return is_dirty_; }
    ui::UnsavedDocument unsaved() const override; ///< which writes nothing yet
    /// A document without a file in which nothing was done: none would miss it.
    bool is_untouched() const { return !path() && history_.n_states() == 1; }

    /// Why no results are to be read: there are none, or they are kept from the class; nothing where they can be.
    std::optional<ui::Message> why_no_results() const;
    /// The load case or combination that is shown, if it alone has no results; null where it has, and in an envelope.
    const BlankCase* shown_blank() const;
    /// What the picture can show: null where there are no results, or none of the case that is shown.
    const femoop::Results* shown_results() const;
    /// Each way in which the structure can move, or is moved by the case that is shown.
    const std::vector<femoop::Mechanism>& shown_mechanisms() const;
    /// The view with an envelope of those cases alone that have results.
    DrawOptions results_view() const;
    bool shows_train_envelope() const { return view.is_envelope && train_envelope.is_on(model()); }
    /// The results as far as they may be told: nothing while they are kept from the class.
    std::optional<femoop::Results> described_results() const;

    ui::DisplayUnits units() const;
    /// The influence line that is looked at, kept from sight while results are hidden; null where there is none.
    const drawing::InfluencePicture* shown_line() const;
    Manner manner() const { return {units(), view.tr}; } ///< of tables
    const ui::Catalogue& tr() const override { return view.tr; }
    void set_language(ui::Language language);

    DrawOptions view;
    DrawState draw_state;
    std::shared_ptr<const ReferenceResults> reference; ///< that the present ones are compared with; null: none
    Selection selection;
    std::optional<Cut> hover;
    std::optional<Cut> pin;
    bool is_still = false; ///< a mechanism swings only where it is animated
    bool is_animated = false;
    bool shows_deformed_to_animate = false; ///< the deformed shape goes when the motion stops
    KeptCounting counting;                  ///< of the degree of indeterminacy, where it is shown
    AskedBody free_body;                    ///< that is lifted out in place of the results of a case
    AskedFunicular funicular;               ///< likewise
    AskedWork virtual_work;                 ///< of a displacement, likewise
    AskedLine influence;                    ///< that is looked at in place of the results of a case
    AskedEnvelope train_envelope;           ///< that takes the place of the cases' where the view shows an envelope
    AskedTruss truss;                       ///< likewise: a plane truss that is worked out by hand
    Prediction prediction;         ///< of moments that the class has not seen yet: part of the tab, not of the document
    std::optional<ShowSet> hidden; ///< results that are kept from the class until they are revealed
    std::size_t mechanism = 0;     ///< which of several is shown
    bool reports_matrices = false; ///< the stiffness and the transformation of every member, in a report
    std::optional<std::size_t> shown_view; ///< the named view that was shown last
    std::optional<Region> look_at;         ///< what the picture is wanted to show; the window takes it

private:
    /// What goes with the document and is no part of it.
    struct Companions {
        Selection selection;
        Prediction prediction;
    };
    /// What comes of a change.
    struct Outcome {
        Document document;
        Companions companions;
        std::optional<ui::Message> objection{}; ///< why it is not to be taken
    };
    Outcome outcome_of(const Change& change) const;
    bool refuse(const Outcome& outcome); ///< and says why; false where nothing is against it
    void accept(const Change& change, Outcome outcome);
    void refresh();
    void notify_dropped(const femoop::Model& before, const femoop::Model& after);
    void prepare_to_go() override;
    void follow(const Document& before) override;
    /// The case that is shown is known by its name.
    void follow_case(const femoop::Model& before, const femoop::Model& after);
    /// What is shown as the present state of the history is left, to be shown again where going back or forth to it
    /// makes or takes away a case.
    void remember_shown();
    void show_as_remembered(const femoop::Model& before);
    /// While a number is dragged, diagrams keep the scale that they had before: one sees them grow.
    void hold_scales(Step step);
    void restart(Document document);

    std::optional<Notice> read(const std::filesystem::path& path) override { return read(path, Purpose::Work); }
    std::optional<Notice> read_draft(const std::filesystem::path& path) override { return read(path, Purpose::Mend); }
    std::optional<Notice> read(const std::filesystem::path& path, Purpose purpose);
    Written write_file(const std::filesystem::path& path) override;
    std::string file_text() const override;
    std::string about(const ui::Catalogue& in) const override;
    void note_saved() override { is_dirty_ = differs_from_saved(); }

    struct Shown {
        std::string load_case;
        bool is_envelope;
    };

    std::map<std::size_t, Shown> shown_at_; ///< by the places of the history
    Companions before_gesture_;
    bool is_dirty_ = false;
    Solution solution_;
    std::uint64_t generation_ = 0;
    std::uint64_t number_;
};

/// Model and results in words, the envelope's numbers where one is shown, and the influence line that is looked at; of
/// hidden results it says that they are hidden.
std::string description(const Session& session);

/// The notice, and the faults that it is about in the words of who writes files, each a line. \pre there is one
std::vector<std::string> notice_lines(const Session& session);
/// Whether nothing was opened; else the notice is about what stands beside the model.
bool ends_headless(const Session& session);

} // namespace frame
