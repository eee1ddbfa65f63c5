#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/drawing/cut.h"
#include "apps/drawing/draw_options.h"
#include "apps/drawing/results/envelope_band.h"
#include "apps/frame/influence/asked_line.h"
#include "femoop/methods/influence/train/train_analysis.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"
#include "femoop/result/magnitudes.h"

namespace frame {

/// The envelope of trains that is looked at: of a train of the model alone or beside a case that stays, or one that the
/// model has. It is no part of the document: it is not saved, nor undone. Trains and cases are known by their names, so
/// that it goes on while the model changes.
class AskedEnvelope {
public:
    struct Choice {
        bool is_of_model = false;     ///< one of the model's envelopes, which has its own case and factor
        std::string name{};           ///< of it, or of the train; where the model lacks it the first train is meant
        std::string with{};           ///< the case that stays; empty: none
        femoop::Quantity factor{1.0}; ///< of the train

        friend bool operator==(const Choice&, const Choice&) = default;
    };

    void turn(bool is_on) { is_on_ = is_on; }
    bool is_on(const femoop::Model& model) const { return is_on_ && !model.moving_loads.trains.empty(); }

    const Choice& choice() const { return choice_; }
    void choose(const Choice& choice) { choice_ = choice; }
    void choose_next(const femoop::Model& model);      ///< train, then envelope of the model, then the first again
    void choose_next_case(const femoop::Model& model); ///< that stays; after the last one none

    /// What is asked for. \pre the model has trains
    femoop::MovingEnvelope envelope(const femoop::Model& model) const;
    /// "Envelope of G + 1.35 × (HS20, lane)". \pre the model has trains
    std::string title(const femoop::Model& model, const drawing::DrawOptions& options) const;

    /// As the options show it: components and reactions. Null where there is none, or none yet, as `why_none` says.
    /// \param generation  grows whenever the model changes  \pre the model has trains
    const drawing::EnvelopePicture* picture(const femoop::Model& model, std::uint64_t generation,
                                            const drawing::DrawOptions& options) const;
    /// The same, however long it takes.
    const drawing::EnvelopePicture* whole_picture(const femoop::Model& model, std::uint64_t generation,
                                                  const drawing::DrawOptions& options) const;
    /// Once a frame: long searches go on by so much that the hand is not held up. Before the first time nothing waits.
    void give_time() const;
    bool is_looking() const { return found_.is_looking; } ///< the search goes on with the next frame
    std::vector<std::string> why_none(const ui::Catalogue& tr) const;

    /// Of each member. \pre there was a picture
    const std::vector<femoop::influence::MemberEnvelope>& members(femoop::MemberComponent component) const;
    /// The value of a section force, or 0 where it is nothing but rounding beside what the trains bring.
    double without_noise(double value, femoop::MemberComponent component) const;
    /// Of one section force or reaction. \pre there was a picture
    femoop::influence::TrainEffect of(const femoop::MovingEffect& effect) const;
    /// The train that governs one end of that range, where it is worst; where none is named the end that is greater
    /// without its sign. \pre there was a picture
    AskedTrain governing(const femoop::Model& model, const femoop::MovingEffect& effect,
                         std::optional<femoop::ExtremeKind> which = {}) const;
    /// Of every section force at a section. \pre there was a picture
    std::vector<femoop::influence::TrainEffect> at(const drawing::Cut& cut) const;
    /// The extremes of every member, as a table a person can read. \pre there was a picture
    std::string words(const drawing::DrawOptions& options) const;
    /// Every section of every member, and every reaction, as comma-separated values. \pre there was a picture
    std::string csv() const;

private:
    using Members = std::vector<femoop::influence::MemberEnvelope>;
    /// What a picture shows, and how it writes.
    struct Look {
        drawing::ShowSet show;
        ui::Language language = ui::Language::English;
        ui::NumberFormat numbers;

        friend bool operator==(const Look&, const Look&) = default;
    };
    struct Found {
        std::uint64_t generation = 0;
        std::shared_ptr<const femoop::Model> model; ///< as it was then
        std::shared_ptr<femoop::influence::TrainAnalysis> analysis;
        std::optional<Choice> choice;
        femoop::MovingEnvelope envelope;
        femoop::Magnitudes brought;                         ///< by its trains at most
        std::map<femoop::MemberComponent, Members> members; ///< each when first asked for
        std::optional<std::vector<femoop::influence::TrainEffect>> reactions;
        std::optional<Look> look; ///< of the picture, once it is drawn
        drawing::EnvelopePicture picture;
        std::vector<femoop::Fault> faults;
        std::optional<femoop::TrainId> too_long; ///< a train whose search would hold up the hand
        bool is_looking = false;
    };
    bool look_at_members() const;
    double size_of_search() const;
    void draw(const drawing::DrawOptions& options) const;
    const std::vector<femoop::influence::TrainEffect>& reactions() const;
    drawing::Bound bound(double value, double noise, const femoop::Train& train) const;
    femoop::Magnitudes brought_by_trains() const;
    double noise(const femoop::MovingEffect& effect) const;
    drawing::EnvelopeBands bands(femoop::MemberComponent component) const;

    bool is_on_ = false;
    Choice choice_;
    mutable Found found_;
    mutable double time_ = 1e300; ///< that is left in this frame [pieces gone through]
};

} // namespace frame
