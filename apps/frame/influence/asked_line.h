#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/drawing/cut.h"
#include "apps/drawing/draw_options.h"
#include "apps/drawing/geometry/projection.h"
#include "apps/drawing/results/influence_picture.h"
#include "apps/drawing/results/train_picture.h"
#include "apps/frame/document/named_effect.h"
#include "apps/frame/influence/candidate_position.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/methods/influence/train/train_analysis.h"
#include "femoop/methods/influence/train/train_search.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"

namespace frame {

/// The train that is wanted on the influence line: known by its name, so that it goes on while the model changes.
struct AskedTrain {
    /// Of its leading axle.
    struct Place {
        double position = 0.0;
        bool reversed = false;

        friend bool operator==(const Place&, const Place&) = default;
    };
    /// The envelope that it was asked in: what stays, if anything does, and the train's factor.
    struct Beside {
        std::string load_case;
        double factor = 1.0;

        friend bool operator==(const Beside&, const Beside&) = default;
    };
    std::string name;                        ///< of the model's trains; empty: none
    bool is_unit_load = false;               ///< a unit load in place of a train, which traces the line as it moves
    std::optional<femoop::ExtremeKind> kind; ///< that it is placed for; nothing: the one of the greater magnitude
    std::optional<Place> place;              ///< where it was put; nothing: where it is worst
    std::optional<Beside> beside{};

    friend bool operator==(const AskedTrain&, const AskedTrain&) = default;
};

/// The influence line that is looked at. It is no part of the document: it is not saved, nor undone, and belongs to the
/// tab that it was asked in. Parts are known by their names, so that it goes on while the model changes.
///
/// The load is a unit force down; its path is the one that is meant where none is named (femoop `usual_path`). Where a
/// train stands on the line, load and path are the train's.
class AskedLine {
public:
    bool is_on(const femoop::Model& model) const { return effect(model).has_value(); }
    void clear();

    /// Of a section: of the force or displacement that was asked for last, else of the bending moment, in a truss of N.
    void ask(const femoop::Model& model, const drawing::Cut& cut);
    /// Of a support its foremost reaction, upright where it can be; of a node without one its displacement down.
    void ask(const femoop::Model& model, femoop::NodeId node);
    /// Of a section force or a reaction in an envelope: with the train that governs, where it is worst.
    void ask(const femoop::Model& model, const femoop::MovingEffect& effect, const AskedTrain& train);
    /// Of the same place. \pre one of `choices`
    void choose(const femoop::MovingEffect& effect);

    /// What is asked for; nothing where its part is gone.
    std::optional<femoop::MovingEffect> effect(const femoop::Model& model) const;
    /// Everything that can be asked for at the same place: forces, then displacements that no support holds.
    std::vector<femoop::MovingEffect> choices(const femoop::Model& model) const;

    /// Keeps the line on the sheet, above those that are asked for next. \pre one is asked for
    void keep(const femoop::Model& model);
    /// What is kept, as far as the model has it.
    std::vector<femoop::MovingEffect> kept(const femoop::Model& model) const;
    void drop(const femoop::Model& model, const femoop::MovingEffect& effect); ///< it is kept no longer
    /// Their pictures, but for that of the line itself, each on the path that is meant without a train.
    /// \pre there is a picture
    const std::vector<drawing::InfluencePicture>& kept_pictures() const { return found_.kept_pictures; }

    /// The line of the model as it is; null where nothing is asked, or the model has no such line.
    /// \param generation  grows whenever the model changes
    const drawing::InfluencePicture* picture(const femoop::Model& model, std::uint64_t generation,
                                             const drawing::DrawOptions& options) const;

    /// The last picture kept from sight. \pre there was one
    const drawing::InfluencePicture& concealed() const;

    const AskedTrain& train() const { return train_; }
    void choose_train(const std::string& name); ///< where it is worst; empty: none
    void seek(femoop::ExtremeKind kind);        ///< where the train is worst in this way
    void put_train(const AskedTrain::Place& place);
    void put_train_back() { train_.place.reset(); }
    /// A unit load at the beginning of the path; it draws the line as far as it is put.
    void trace();
    bool is_traced() const { return train_.is_unit_load; }
    void put_unit_load(double s); ///< there, where the whole line has been traced

    /// How the structure bears the unit load. \pre it stands
    const femoop::Results& results() const { return *found_.results; }

    /// It in words, with what stands on it. \pre there is a last picture
    std::string words(const drawing::DrawOptions& options) const;

    /// What stands on the last picture; null where none does.
    const drawing::StandingTrain* standing() const { return found_.standing ? &*found_.standing : nullptr; }
    /// Where the train is worst; nothing where its axles are best away. \pre it stands
    std::optional<AskedTrain::Place> worst_place() const;
    /// The proof of that: every position where it may be worst. \pre it stands
    const std::vector<CandidatePosition>& candidates() const { return found_.candidates; }
    /// Whether it stands there. \pre it stands
    bool stands_at(const AskedTrain::Place& place) const;
    /// The model with that train as its only load. \pre it stands
    const femoop::Model& loaded() const { return *found_.loaded; }
    /// Where its leading axle may be put. \pre it stands, and has axles
    femoop::influence::Stretch positions(bool reversed) const { return found_.search->positions(reversed); }
    /// Of the place of the last picture's path, or of its straight prolongations, that is seen nearest to one of the
    /// sheet. \pre there was one
    double nearest_on_path(const drawing::Projection& projection, ui::Point at) const;

private:
    /// As the reader knows it.
    struct UnitLoad {
        std::string name;
        double force = 1.0; ///< that is 1 in his units

        friend bool operator==(const UnitLoad&, const UnitLoad&) = default;
    };
    struct Found {
        std::uint64_t generation = 0;
        std::shared_ptr<const femoop::Model> model;                     ///< as it was then
        std::shared_ptr<femoop::influence::InfluenceAnalysis> analysis; ///< null: the model has no lines
        std::shared_ptr<femoop::influence::TrainAnalysis> trains;       ///< made when there is the first one
        std::optional<femoop::MovingEffect> effect;
        AskedTrain train;
        std::shared_ptr<const femoop::influence::TrainSearch> search; ///< of that train on that effect
        std::optional<drawing::InfluencePicture> picture, concealed;
        std::optional<drawing::StandingTrain> standing;
        femoop::influence::WorstPlacings worst;    ///< of that train
        std::optional<femoop::ExtremeKind> sought; ///< that the candidates are for
        std::vector<CandidatePosition> candidates;
        double permanent = 0.0; ///< what stays beside that train does to the effect
        std::optional<femoop::Model> loaded;
        std::optional<femoop::Results> results; ///< of the unit load
        UnitLoad unit_load;
        std::vector<femoop::MovingEffect> kept;
        std::vector<drawing::InfluencePicture> kept_pictures;
        std::vector<femoop::Fault> faults; ///< why the train cannot stand
    };
    void find(const femoop::MovingEffect& effect) const;
    void find_unit_load() const;
    void find_line(const femoop::MovingEffect& effect) const;
    void find_kept() const;
    drawing::InfluencePicture line_alone(const femoop::MovingEffect& effect) const;
    void find_line_of_train(const femoop::Train& train, const femoop::MovingEffect& effect) const;
    const femoop::influence::Placing& worst_placing() const;
    void stand_train() const;
    femoop::influence::Placing placed(const AskedTrain::Place& place, femoop::ExtremeKind kind) const;
    void begin_trace();
    void search_line() const;
    void trace_line() const;
    void find_candidates() const;
    void load_train() const;
    drawing::PositionCurve curve() const;
    std::vector<std::string> sentences(const drawing::DrawOptions& options) const;
    std::string sum_with_permanent(const drawing::DrawOptions& options) const;

    std::optional<NamedEffect> asked_;
    std::vector<NamedEffect> kept_;
    AskedTrain train_;
    mutable double traced_to_ = 0.0; ///< by the unit load, as it was seen
    femoop::MemberComponent last_component_ = femoop::MemberComponent::Mz;
    mutable Found found_;
};

/// The effect that is meant first at a section or at a node, as `AskedLine::ask` takes it; nothing where the model has
/// not that part.
template <class Place>
std::optional<femoop::MovingEffect> foremost_effect(const femoop::Model& model, const Place& place)
{
    AskedLine line;
    line.ask(model, place);
    return line.effect(model);
}

} // namespace frame
