#include "apps/frame/predict/prediction.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "femoop/result/curve_reader.h"

namespace frame {

using femoop::MemberId;

void Prediction::draw(const femoop::Model& model, const PredictedSubject& shown, MemberId member,
                      std::span<const StrokePoint> stroke)
{
    if (shown.index() != subject_.index()) clear();
    auto entry = std::ranges::find(guesses_, member, &Entry::member);
    Guess guess = entry != guesses_.end() ? entry->guess : Guess();
    guess.draw(stroke);
    if (guess.is_empty()) return;
    if (!drawn_for_) {
        drawn_for_ = model;
        subject_ = shown;
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

bool Prediction::is_stale(const femoop::Model& model, const PredictedSubject& shown) const
{
    return drawn_for_ && (shown != subject_ || model != *drawn_for_);
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
    double ordinate = 0.0, drawn = 0.0;

    void add(double true_ordinate, const Guess* guess, double length)
    {
        ordinate = std::max(ordinate, true_ordinate);
        if (guess != nullptr) drawn = std::max(drawn, guess->largest() * length);
    }
};

/// What is true of one member, and what was drawn on it.
struct Beside {
    MemberId member;
    double length = 0.0, ordinate = 0.0; ///< the largest one
    const Guess* guess = nullptr;        ///< null: nothing was drawn
};

// A hand that follows the axis trembles a little, beside the member or beside what it drew elsewhere.
bool is_on_axis(const Beside& one, const Largest& all)
{
    constexpr double tremble = 0.02;
    return one.guess->largest() <= tremble || one.guess->largest() * one.length <= faint * all.drawn;
}

/// \param true_diagram  makes the `Truth` of that member
template <class MakeTruth>
std::optional<MemberMark> mark(const Beside& one, const Largest& all, const MakeTruth& true_diagram)
{
    const MemberId member = one.member;
    const bool has_ordinates = one.ordinate > nothing * all.ordinate, is_seen = one.ordinate > faint * all.ordinate;
    if (!one.guess) return is_seen ? std::optional(MemberMark{member, Outcome::NotDrawn, {}}) : std::nullopt;
    if (is_on_axis(one, all))
        return MemberMark{
            member, is_seen ? Outcome::DrawnAsZero : Outcome::RightlyZero, {.share = is_seen ? 0.0 : 1.0}};
    if (!has_ordinates) return MemberMark{member, Outcome::NotZero, {}};
    return MemberMark{member, Outcome::Judged, score(true_diagram(), *one.guess)};
}

void add(Assessment& assessment, std::optional<MemberMark> mark)
{
    if (mark) assessment.members.push_back(std::move(*mark));
}

Assessment weighed(Assessment assessment)
{
    for (const MemberMark& mark : assessment.members) assessment.share += mark.score.share;
    if (!assessment.members.empty()) assessment.share /= static_cast<double>(assessment.members.size());
    return assessment;
}

} // namespace

std::optional<Assessment> assess(const Prediction& prediction, const femoop::Results& results, femoop::CaseId shown)
{
    const bool can_be_judged = results.analysis() == femoop::AnalysisKind::Frame2d && shown.index < results.n_cases();
    if (prediction.is_empty() || prediction.is_of_line() || !can_be_judged) return std::nullopt;
    femoop::CurveReader reader(results[shown]);
    std::vector<Beside> members;
    Largest all;
    for (std::size_t i = 0; i < results.n_members(); ++i) {
        const MemberId member(i);
        const femoop::Curve& curve = reader.read(member);
        members.push_back({member, curve.length(), largest(curve), prediction.on(member)});
        all.add(members.back().ordinate, members.back().guess, curve.length());
    }
    Assessment assessment;
    for (const Beside& one : members)
        add(assessment, mark(one, all, [&] { return truth(reader.read(one.member), femoop::MemberComponent::Mz); }));
    return weighed(std::move(assessment));
}

std::optional<Assessment> assess(const Prediction& prediction, const femoop::influence::InfluenceLine& line,
                                 const femoop::influence::PathLayout& path)
{
    if (prediction.is_empty() || !prediction.is_of_line()) return std::nullopt;
    std::vector<Truth> truths;
    std::vector<Beside> members;
    Largest all;
    for (const femoop::influence::PathMember& on : path.members) {
        truths.push_back(truth(line, on));
        members.push_back({on.member, on.length, truths.back().largest, prediction.on(on.member)});
        all.add(members.back().ordinate, members.back().guess, on.length);
    }
    Assessment assessment{.members = {}, .is_of_line = true};
    for (std::size_t i = 0; i < members.size(); ++i)
        add(assessment, mark(members[i], all, [&]() -> const Truth& { return truths[i]; }));
    return weighed(std::move(assessment));
}

} // namespace frame
