#include "apps/frame/predict/prediction.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "femoop/result/curve_reader.h"

namespace frame {

using femoop::MemberId;

void Prediction::draw(const femoop::Model& model, femoop::CaseId shown, MemberId member,
                      std::span<const StrokePoint> stroke)
{
    auto entry = std::ranges::find(guesses_, member, &Entry::member);
    Guess guess = entry != guesses_.end() ? entry->guess : Guess();
    guess.draw(stroke);
    if (guess.is_empty()) return;
    if (!drawn_for_) {
        drawn_for_ = model;
        case_ = shown;
    }
    if (entry != guesses_.end()) entry->guess = guess;
    else guesses_.push_back({member, guess});
}

const Guess* Prediction::on(MemberId member) const
{
    const auto entry = std::ranges::find(guesses_, member, &Entry::member);
    return entry != guesses_.end() ? &entry->guess : nullptr;
}

void Prediction::follow(const femoop::Model& before, const femoop::Model& after)
{
    std::vector<Entry> kept;
    for (const Entry& entry : guesses_) {
        if (entry.member.index >= before.members.size()) continue;
        const std::string& name = before[entry.member].id;
        const auto found = std::ranges::find(after.members, name, &femoop::Member::id);
        if (found == after.members.end()) continue;
        kept.push_back({MemberId(static_cast<std::size_t>(found - after.members.begin())), entry.guess});
    }
    guesses_ = std::move(kept);
    if (guesses_.empty()) clear();
}

bool Prediction::is_stale(const femoop::Model& model, femoop::CaseId shown) const
{
    return drawn_for_ && (shown != case_ || model != *drawn_for_);
}

namespace {

// A diagram that is lower than this beside the largest of all members looks like the axis.
constexpr double faint = 0.03;
constexpr double nothing = 2e-5; // what rounding leaves

double largest(const femoop::Curve& curve)
{
    const femoop::Extremes extremes = curve.extremes(femoop::MemberComponent::Mz);
    return std::max(std::abs(extremes.max.value), std::abs(extremes.min.value));
}

/// The largest ordinates of the structure: true ones, and drawn ones as lengths.
struct Largest {
    double moment = 0.0, drawn = 0.0;
};

Largest largest(const Prediction& prediction, const femoop::Results& results, femoop::CaseId shown)
{
    Largest all;
    femoop::CurveReader reader(results[shown]);
    for (std::size_t i = 0; i < results.n_members(); ++i) {
        const femoop::Curve& curve = reader.read(MemberId(i));
        all.moment = std::max(all.moment, largest(curve));
        if (const Guess* guess = prediction.on(MemberId(i)))
            all.drawn = std::max(all.drawn, guess->largest() * curve.length());
    }
    return all;
}

// A hand that follows the axis trembles a little, beside the member or beside what it drew elsewhere.
bool is_on_axis(const Guess& guess, double length, const Largest& all)
{
    constexpr double tremble = 0.02;
    return guess.largest() <= tremble || guess.largest() * length <= faint * all.drawn;
}

std::optional<MemberMark> mark(MemberId member, const femoop::Curve& curve, const Guess* guess, const Largest& all)
{
    const double moment = largest(curve);
    const bool has_moments = moment > nothing * all.moment, is_seen = moment > faint * all.moment;
    if (!guess) return is_seen ? std::optional(MemberMark{member, Outcome::NotDrawn, {}}) : std::nullopt;
    if (is_on_axis(*guess, curve.length(), all))
        return MemberMark{
            member, is_seen ? Outcome::DrawnAsZero : Outcome::RightlyZero, {.share = is_seen ? 0.0 : 1.0}};
    if (!has_moments) return MemberMark{member, Outcome::NotZero, {}};
    return MemberMark{member, Outcome::Judged, score(truth(curve, femoop::MemberComponent::Mz), *guess)};
}

} // namespace

std::optional<Assessment> assess(const Prediction& prediction, const femoop::Results& results, femoop::CaseId shown)
{
    const bool can_be_judged = results.analysis() == femoop::AnalysisKind::Frame2d && shown.index < results.n_cases();
    if (prediction.is_empty() || !can_be_judged) return std::nullopt;
    const Largest all = largest(prediction, results, shown);
    femoop::CurveReader reader(results[shown]);
    Assessment assessment;
    for (std::size_t i = 0; i < results.n_members(); ++i) {
        const MemberId member(i);
        if (auto one = mark(member, reader.read(member), prediction.on(member), all)) {
            assessment.share += one->score.share;
            assessment.members.push_back(std::move(*one));
        }
    }
    if (!assessment.members.empty()) assessment.share /= static_cast<double>(assessment.members.size());
    return assessment;
}

} // namespace frame
