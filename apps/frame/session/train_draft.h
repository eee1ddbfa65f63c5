#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/frame/session/session.h"
#include "femoop/methods/influence/train/train_library.h"

namespace frame {

/// The trains of the document while they are edited: the document has them already, as a gesture that is under way, so
/// that the line or the envelope beside them shows what becomes of them. `accept` settles all of it as one step,
/// `cancel` takes it back.
class TrainDraft {
public:
    bool is_open() const { return is_open_; }
    /// With the train that stands on the influence line, else the first one.
    /// \pre the model has members
    void open(Session& session);
    void accept(Session& session);
    void cancel(Session& session);

    const std::vector<femoop::Train>& trains() const { return loads_.trains; }
    std::size_t chosen() const { return chosen_; }
    const femoop::Train& train() const { return loads_.trains[chosen_]; } ///< \pre there are trains
    void choose(Session& session, std::size_t train);

    void add_usual(Session& session);
    void add(Session& session, const femoop::influence::LibraryTrain& entry); ///< of the library
    void add_copy(Session& session);
    void erase(Session& session);
    std::optional<ui::Message> set_name(Session& session, std::string_view name); ///< \returns why it cannot have it

    /// \returns why the train cannot be so; it stays then as it was
    std::optional<femoop::Fault> change(Session& session, const std::function<void(femoop::Train&)>& how);

    /// What a scenario says: "choose HS20", "take TB-450", "new", "copy", "delete", "name lorry", "axle 2 120 kN",
    /// "distance 1 3 m", "longest 1 9 m", "uniform 10 kN/m", "impact 1.3", "both yes", "add_axle", "delete_axle 2",
    /// "accept", "cancel". \returns the complaint
    std::optional<std::string> run_command(Session& session, std::string_view verb, std::string_view argument);

private:
    void append(Session& session, femoop::Train train);
    void show(Session& session);
    void follow(Session& session) const; ///< the line and the envelope look at the chosen train, if they did
    femoop::LoadPathReference usual_path(const Session& session) const;
    std::optional<std::string> run_on_trains(Session& session, std::string_view verb, std::string_view argument);
    std::optional<std::string> run_on_axles(Session& session, std::string_view verb, std::string_view argument);

    bool is_open_ = false;
    femoop::MovingLoads loads_;
    std::size_t chosen_ = 0;
    std::string looked_at_;             ///< by the line, before
    AskedEnvelope::Choice enveloped_{}; ///< likewise
};

} // namespace frame
