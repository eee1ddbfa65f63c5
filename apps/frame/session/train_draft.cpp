#include "apps/frame/session/train_draft.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "apps/frame/document/fault/sentence.h"
#include "apps/frame/document/naming.h"
#include "apps/frame/document/number.h"
#include "apps/frame/document/selected_members.h"
#include "apps/frame/document/train_command.h"
#include "femoop/methods/influence/load_path.h"
#include "femoop/methods/influence/usual_path.h"
#include "femoop/model/check/check.h"

namespace frame {

using femoop::Quantity;
using femoop::Train;
using ui::Measure;
using ui::Message;
using ui::translatable;

void TrainDraft::open(Session& session)
{
    if (is_open_) return;
    session.settle();
    is_open_ = true;
    loads_ = session.model().moving_loads;
    looked_at_ = session.influence.train().name;
    enveloped_ = session.train_envelope.choice();
    const auto standing = std::ranges::find(loads_.trains, looked_at_, &Train::id);
    chosen_ = standing != loads_.trains.end() ? static_cast<std::size_t>(standing - loads_.trains.begin()) : 0;
}

void TrainDraft::accept(Session& session)
{
    session.settle();
    is_open_ = false;
}

void TrainDraft::cancel(Session& session)
{
    session.cancel();
    is_open_ = false;
    session.train_envelope.choose(enveloped_);
    if (session.influence.is_on(session.model()) && !session.influence.is_traced())
        session.influence.choose_train(looked_at_);
}

void TrainDraft::choose(Session& session, std::size_t train)
{
    chosen_ = train;
    follow(session);
}

void TrainDraft::add_usual(Session& session)
{
    append(session, usual_train(session.model().units, usual_path(session)));
}

void TrainDraft::add(Session& session, const femoop::influence::LibraryTrain& entry)
{
    append(session, train_from(entry, session.model().units, usual_path(session)));
}

void TrainDraft::add_copy(Session& session) { append(session, train()); }

void TrainDraft::append(Session& session, Train train)
{
    train.id = fresh_train_name(loads_.trains, train.id);
    loads_.trains.push_back(std::move(train));
    chosen_ = loads_.trains.size() - 1;
    show(session);
}

void TrainDraft::erase(Session& session)
{
    erase_train(loads_, femoop::TrainId(chosen_));
    if (chosen_ > 0 && chosen_ == loads_.trains.size()) --chosen_;
    show(session);
}

std::optional<Message> TrainDraft::set_name(Session& session, std::string_view name)
{
    if (auto reason = objection(loads_.trains, &Train::id, chosen_, name)) return reason;
    loads_.trains[chosen_].id = name;
    show(session);
    return std::nullopt;
}

std::optional<femoop::Fault> TrainDraft::change(Session& session, const std::function<void(Train&)>& how)
{
    Train next = train();
    how(next);
    const std::vector<femoop::Fault> faults = check_train(session.model(), next, {"trains", chosen_});
    if (!faults.empty()) return faults.front();
    loads_.trains[chosen_] = std::move(next);
    show(session);
    return std::nullopt;
}

void TrainDraft::show(Session& session)
{
    session.change({translatable("Change the trains"),
                    [this](Document& document) { document.model.moving_loads = loads_; }, Step::Drag});
    follow(session);
}

void TrainDraft::follow(Session& session) const
{
    if (loads_.trains.empty()) return;
    const bool has_train = session.influence.is_on(session.model()) && !session.influence.is_traced();
    if (has_train && session.influence.train().name != train().id) session.influence.choose_train(train().id);
    AskedEnvelope::Choice choice = session.train_envelope.choice();
    choice.is_of_model = false;
    choice.name = train().id;
    session.train_envelope.choose(choice);
}

// That of the train that is shown, else the first of the file, else the one that is meant where what is selected bends.
femoop::LoadPathReference TrainDraft::usual_path(const Session& session) const
{
    const femoop::Model& model = session.model();
    if (!loads_.trains.empty()) return train().path;
    if (!loads_.paths.empty()) return femoop::PathId(0);
    const std::vector<femoop::MemberId> selected = selected_members(session.selection);
    const femoop::MovingEffect bent{.member = selected.empty() ? femoop::MemberId(0) : selected.front()};
    return femoop::influence::usual_path(model, bent, femoop::influence::unit_load(model.analysis, {}));
}

namespace {

std::optional<std::string> complaint(const std::optional<femoop::Fault>& fault)
{
    return fault ? std::optional(sentence(*fault, ui::Catalogue())) : std::nullopt;
}

} // namespace

std::optional<std::string> TrainDraft::run_command(Session& session, std::string_view verb, std::string_view argument)
{
    if (!is_open_) return "no train is being edited; begin with train.edit";
    if (verb == "accept") accept(session);
    else if (verb == "cancel") cancel(session);
    else if (verb == "new") add_usual(session);
    else if (verb == "choose" || verb == "take" || loads_.trains.empty()) return run_on_trains(session, verb, argument);
    else if (verb == "copy") add_copy(session);
    else if (verb == "delete") erase(session);
    else if (verb == "name") {
        if (const auto reason = set_name(session, argument)) return ui::Catalogue()(*reason);
    } else if (verb == "both")
        return complaint(change(session, [&](Train& train) { train.both_directions = argument != "no"; }));
    else if (verb == "add_axle")
        return complaint(change(session, [&](Train& train) { add_axle(train, session.model().units); }));
    else return run_on_axles(session, verb, argument);
    return std::nullopt;
}

std::optional<std::string> TrainDraft::run_on_trains(Session& session, std::string_view verb, std::string_view argument)
{
    if (verb == "choose") {
        const auto found = std::ranges::find(loads_.trains, argument, &Train::id);
        if (found == loads_.trains.end()) return "no train \"" + std::string(argument) + "\"";
        choose(session, static_cast<std::size_t>(found - loads_.trains.begin()));
        return std::nullopt;
    }
    const auto library = femoop::influence::train_library();
    const auto found = std::ranges::find(library, argument, &femoop::influence::LibraryTrain::name);
    if (verb != "take" || found == library.end()) return "no train \"" + std::string(argument) + "\"";
    add(session, *found);
    return std::nullopt;
}

// The axle's number comes first, but for what the train has once.
std::optional<std::string> TrainDraft::run_on_axles(Session& session, std::string_view verb, std::string_view argument)
{
    std::size_t axle = 0;
    std::string_view text = argument;
    if (verb != "uniform" && verb != "impact") {
        const auto [end, error] = std::from_chars(argument.data(), argument.data() + argument.size(), axle);
        const std::size_t n = verb == "axle" || verb == "delete_axle" ? train().axles.size() : train().spacings.size();
        if (error != std::errc() || axle == 0 || axle > n) return "no axle \"" + std::string(argument) + "\"";
        text = argument.substr(static_cast<std::size_t>(end - argument.data()));
        --axle;
    }
    if (verb == "delete_axle") return complaint(change(session, [&](Train& train) { erase_axle(train, axle); }));
    const Measure measure = verb == "axle"      ? Measure::Force
                            : verb == "uniform" ? Measure::ForcePerLength
                            : verb == "impact"  ? Measure::Plain
                                                : Measure::Length;
    const auto typed = quantity_typed(text, measure, session.model().units, session.units());
    const auto* const value = std::get_if<Quantity>(&typed);
    if (value == nullptr) return "no quantity in \"" + std::string(argument) + "\"";
    return complaint(change(session, [&](Train& train) {
        if (verb == "axle") train.axles[axle] = *value;
        else if (verb == "distance") set_spacing(train, axle, *value);
        else if (verb == "longest") set_longest_spacing(train, axle, *value);
        else if (verb == "uniform") train.uniform = *value;
        else train.impact = value->value();
    }));
}

} // namespace frame
