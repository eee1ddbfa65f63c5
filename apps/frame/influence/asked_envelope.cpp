#include "apps/frame/influence/asked_envelope.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "apps/drawing/results/range_words.h"
#include "apps/drawing/results/solved_case.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/drawing/sketch/table_units.h"
#include "apps/frame/document/fault/sentence.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/io/train/train_csv.h"
#include "femoop/io/train/train_table.h"
#include "femoop/methods/influence/usual_path.h"
#include "femoop/result/components.h"

namespace frame {

using femoop::MemberComponent;
using femoop::MemberId;
using femoop::Model;
using femoop::MovingEffect;
using femoop::MovingEnvelope;
using femoop::Train;
using femoop::influence::TrainEffect;

namespace {

constexpr double all_time = 1e300, time_of_frame = 1e5; // [pieces gone through], some 4e5 a second
constexpr double longest_search = 4e5;                  // of one component of one member, which is not parted

MovingEffect of_member(MemberId member, MemberComponent component)
{
    return {.quantity = femoop::ExpectedQuantity::Extreme, .member = member, .component = component};
}

/// What a train brings onto the structure at most.
double weight(const Train& train, double length)
{
    double sum = train.uniform ? std::abs(train.uniform->value()) * length : 0.0;
    for (const femoop::Quantity& axle : train.axles) sum += std::abs(axle.value() * train.impact);
    for (const femoop::ConcentratedForce& force : train.concentrated) sum += std::abs(force.for_moments.value());
    return sum;
}

} // namespace

void AskedEnvelope::choose_next(const Model& model)
{
    const auto& [paths, lines, trains, envelopes] = model.moving_loads;
    std::vector<Choice> all;
    for (const Train& train : trains) all.push_back({.name = train.id, .with = choice_.with, .factor = choice_.factor});
    for (const MovingEnvelope& envelope : envelopes)
        all.push_back({.is_of_model = true, .name = envelope.id, .with = choice_.with, .factor = choice_.factor});
    if (choice_.name.empty() && !all.empty()) choice_.name = all.front().name;
    const auto now = std::ranges::find(all, choice_);
    const bool has_next = now != all.end() && now + 1 != all.end();
    if (!all.empty()) choice_ = has_next ? *(now + 1) : all.front();
}

void AskedEnvelope::choose_next_case(const Model& model)
{
    const auto now = model.find_case(choice_.with);
    const std::size_t next = now ? now->index + 1 : 0;
    choice_.is_of_model = false;
    choice_.with = next < model.n_cases() ? model.case_name(femoop::CaseId(next)) : std::string();
}

MovingEnvelope AskedEnvelope::envelope(const Model& model) const
{
    const auto& [paths, lines, trains, envelopes] = model.moving_loads;
    const auto own = std::ranges::find(envelopes, choice_.name, &MovingEnvelope::id);
    if (choice_.is_of_model && own != envelopes.end()) return *own;
    const auto named = std::ranges::find(trains, choice_.name, &Train::id);
    const auto train = named != trains.end() ? named : trains.begin();
    return {.id = train->id,
            .trains = {femoop::TrainId(static_cast<std::size_t>(train - trains.begin()))},
            .with = model.find_case(choice_.with),
            .factor = choice_.factor.value()};
}

std::string AskedEnvelope::title(const Model& model, const drawing::DrawOptions& options) const
{
    return options.tr("Envelope of {cases}", {{"cases", load_name(model, options, envelope(model))}});
}

const drawing::EnvelopePicture* AskedEnvelope::picture(const Model& model, std::uint64_t generation,
                                                       const drawing::DrawOptions& options) const
{
    if (found_.generation != generation) found_ = {.generation = generation};
    if (found_.choice != choice_) {
        found_.choice = choice_;
        found_.look.reset();
        found_.members.clear();
        found_.reactions.reset();
        found_.faults.clear();
        found_.too_long.reset();
        found_.is_looking = false;
    }
    if (!found_.faults.empty() || found_.too_long) return nullptr;
    const Look look{options.show, options.tr.language(), options.numbers};
    if (found_.look == look) return &found_.picture;
    try {
        if (!found_.model) found_.model = std::make_shared<const Model>(model);
        if (!found_.analysis) found_.analysis = std::make_shared<femoop::influence::TrainAnalysis>(*found_.model);
        found_.envelope = envelope(*found_.model);
        found_.brought = brought_by_trains();
        found_.is_looking = !look_at_members();
        if (found_.is_looking || found_.too_long) return nullptr;
        draw(options);
        found_.look = look;
    } catch (const femoop::ModelError& error) {
        found_.faults = error.faults();
        return nullptr;
    }
    return &found_.picture;
}

const drawing::EnvelopePicture* AskedEnvelope::whole_picture(const Model& model, std::uint64_t generation,
                                                             const drawing::DrawOptions& options) const
{
    const double left = std::exchange(time_, all_time);
    const auto* const found = picture(model, generation, options);
    time_ = left;
    return found;
}

void AskedEnvelope::give_time() const { time_ = time_of_frame; }

std::vector<std::string> AskedEnvelope::why_none(const ui::Catalogue& tr) const
{
    std::vector<std::string> all;
    for (const femoop::Fault& fault : found_.faults) all.push_back(sentence(fault, tr));
    if (found_.too_long) {
        const Train& train = found_.model->moving_loads.trains[found_.too_long->index];
        all.push_back(
            tr("{train}: {count} spacings vary; the worst of all sections would be looked for too long. Let fewer "
               "of them vary, or ask for the influence line of one section",
               {{"train", train.id}, {"count", std::to_string(train.spacing_ranges.size())}}));
    }
    if (found_.is_looking) {
        std::size_t done = 0;
        for (const auto& [component, members] : found_.members) done += members.size();
        const std::size_t n = found_.model->members.size() *
                              femoop::section_force_components(found_.model->analysis).size();
        all.push_back(tr("Looking for the worst sections: {percent}%", {{"percent", std::to_string(100 * done / n)}}));
    }
    return all;
}

/// Of one component of one member under all trains.
double AskedEnvelope::size_of_search() const
{
    double size = 0.0;
    for (const femoop::TrainId id : found_.envelope.trains) {
        const double one = femoop::influence::search_size(*found_.model, found_.model->moving_loads.trains[id.index]);
        if (one > longest_search) found_.too_long = id;
        size += one;
    }
    return size;
}

/// As far as the time of this frame goes, at least one. \returns whether all are known
bool AskedEnvelope::look_at_members() const
{
    constexpr std::size_t n_sections = 41; // of each member: between two of them a line is near enough to the band
    const double size = size_of_search();
    if (found_.too_long) return true;
    for (const MemberComponent component : femoop::section_force_components(found_.model->analysis)) {
        Members& known = found_.members[component];
        while (known.size() < found_.model->members.size()) {
            if (time_ <= 0.0) return false;
            known.push_back(found_.analysis->along_member(found_.envelope, of_member(MemberId(known.size()), component),
                                                          n_sections));
            time_ -= size;
        }
    }
    return true;
}

void AskedEnvelope::draw(const drawing::DrawOptions& options) const
{
    const Model& model = *found_.model;
    found_.picture = {.title = title(model, options)};
    for (const femoop::TrainId id : found_.envelope.trains)
        found_.picture.names.push_back(model.moving_loads.trains[id.index].id);
    for (const MemberComponent component : drawing::shown_components(options.show, model.analysis))
        found_.picture.bands.push_back(bands(component));
    const std::vector<TrainEffect>& all = reactions(); // a load that cannot be borne is found though nothing is shown
    if (!options.show.contains(drawing::Show::Reactions)) return;
    for (const TrainEffect& effect : all) {
        const double least = noise(effect.effect);
        found_.picture.reactions.push_back({.node = *effect.effect.node,
                                            .dof = *effect.effect.dof,
                                            .least = bound(effect.min.value, least, *effect.min_train),
                                            .most = bound(effect.max.value, least, *effect.max_train)});
    }
}

const AskedEnvelope::Members& AskedEnvelope::members(MemberComponent component) const
{
    return found_.members.at(component);
}

const std::vector<TrainEffect>& AskedEnvelope::reactions() const
{
    if (found_.reactions) return *found_.reactions;
    std::vector<MovingEffect> all;
    for (std::size_t i = 0; i < found_.model->nodes.size(); ++i)
        std::ranges::move(femoop::influence::reactions_at(*found_.model, femoop::NodeId(i)), std::back_inserter(all));
    return found_.reactions.emplace(found_.analysis->effects(found_.envelope, all));
}

TrainEffect AskedEnvelope::of(const MovingEffect& effect) const
{
    return found_.analysis->effects(found_.envelope, {{effect}}).front();
}

AskedTrain AskedEnvelope::governing(const Model& model, const MovingEffect& effect,
                                    std::optional<femoop::ExtremeKind> which) const
{
    using femoop::ExtremeKind;
    const TrainEffect found = of(effect);
    const bool is_larger = std::abs(found.max.value) >= std::abs(found.min.value);
    const ExtremeKind kind = which.value_or(is_larger ? ExtremeKind::Max : ExtremeKind::Min);
    const MovingEnvelope shown = envelope(model);
    AskedTrain train{.name = (kind == ExtremeKind::Max ? found.max_train : found.min_train)->id, .kind = kind};
    if (shown.with || shown.factor != 1.0)
        train.beside = {shown.with ? model.case_name(*shown.with) : std::string(), shown.factor};
    return train;
}

std::vector<TrainEffect> AskedEnvelope::at(const drawing::Cut& cut) const
{
    const double length = femoop::geometry_of(*found_.model, (*found_.model)[cut.member]).length;
    std::vector<MovingEffect> asked;
    for (const MemberComponent component : femoop::section_force_components(found_.model->analysis))
        asked.push_back(femoop::influence::at_section(of_member(cut.member, component), cut.x, length));
    return found_.analysis->effects(found_.envelope, asked);
}

femoop::Magnitudes AskedEnvelope::brought_by_trains() const
{
    femoop::Magnitudes most;
    for (const femoop::TrainId id : found_.envelope.trains) {
        const Train& train = found_.model->moving_loads.trains[id.index];
        const double length = found_.analysis->path(train).length();
        const double force = weight(train, length) * std::abs(found_.envelope.factor);
        most.force = std::max(most.force, force);
        most.moment = std::max(most.moment, force * length);
    }
    return most;
}

// What the analysis leaves of an effect that is none is rounding beside what the trains bring.
double AskedEnvelope::noise(const MovingEffect& effect) const
{
    constexpr double rounding = 1e-9;
    return rounding * (femoop::influence::is_moment(effect) ? found_.brought.moment : found_.brought.force);
}

double AskedEnvelope::without_noise(double value, MemberComponent component) const
{
    const MovingEffect any{.quantity = femoop::ExpectedQuantity::SectionForce, .component = component};
    return std::abs(value) > noise(any) ? value : 0.0;
}

drawing::Bound AskedEnvelope::bound(double value, double noise, const Train& train) const
{
    const auto& ids = found_.envelope.trains;
    const Train* const first = found_.model->moving_loads.trains.data();
    const auto maker = std::ranges::find(ids, femoop::TrainId(static_cast<std::size_t>(&train - first)));
    return {std::abs(value) > noise ? value : 0.0, static_cast<std::size_t>(maker - ids.begin())};
}

drawing::EnvelopeBands AskedEnvelope::bands(MemberComponent component) const
{
    drawing::EnvelopeBands bands{.component = component, .members = {}};
    for (const femoop::influence::MemberEnvelope& member : members(component)) {
        std::vector<drawing::BandSection>& band = bands.members.emplace_back();
        const double least = noise(member.extreme.effect);
        for (const TrainEffect& effect : member.sections)
            band.push_back({.x = std::get<femoop::Quantity>(*effect.effect.at).value(),
                            .least = bound(effect.min.value, least, *effect.min_train),
                            .most = bound(effect.max.value, least, *effect.max_train)});
    }
    return bands;
}

std::string AskedEnvelope::words(const drawing::DrawOptions& options) const
{
    femoop::influence::TrainResults results{.id = found_.envelope.id, .is_envelope = found_.envelope.trains.size() > 1};
    for (const MemberComponent component : femoop::section_force_components(found_.model->analysis))
        for (const femoop::influence::MemberEnvelope& member : members(component))
            results.extremes.push_back(member.extreme);
    return range_words(*found_.model, options, results, title(*found_.model, options)) + "\n" +
           femoop::influence::trains_text(*found_.model, {results},
                                          drawing::table_units(drawing::display_units(*found_.model, options)),
                                          options.tr);
}

std::string AskedEnvelope::csv() const
{
    std::vector<TrainEffect> all = reactions();
    for (const MemberComponent component : femoop::section_force_components(found_.model->analysis))
        for (const femoop::influence::MemberEnvelope& member : members(component))
            all.insert(all.end(), member.sections.begin(), member.sections.end());
    return femoop::influence::trains_csv(*found_.model, all);
}

} // namespace frame
