#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "apps/frame/predict/score.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace frame {

/// What a class sketches of the bending moments of a plane frame before it sees them. It is no part of the document:
/// it is not saved, nor undone, and belongs to the tab that it was drawn in.
class Prediction {
public:
    /// Draws on a member of the model, in the case that is shown. The first stroke of all says what the whole is about.
    void draw(const femoop::Model& model, femoop::CaseId shown, femoop::MemberId member,
              std::span<const StrokePoint> stroke);
    const Guess* on(femoop::MemberId member) const; ///< null where nothing is drawn
    bool is_empty() const { return guesses_.empty(); }
    void clear() { *this = {}; }

    /// Goes on from one state of a model to the next: members are known by their names; those that are gone are
    /// dropped.
    void follow(const femoop::Model& before, const femoop::Model& after);
    /// It was drawn for another state of the model, or another case.
    bool is_stale(const femoop::Model& model, femoop::CaseId shown) const;

private:
    struct Entry {
        femoop::MemberId member;
        Guess guess;
    };
    std::vector<Entry> guesses_;
    std::optional<femoop::Model> drawn_for_;
    femoop::CaseId case_;
};

/// What became of the guess on one member.
enum class Outcome : std::uint8_t {
    Judged,
    NotDrawn,    ///< though there are moments
    DrawnAsZero, ///< though there are moments
    NotZero,     ///< though there are none
    RightlyZero  ///< no moments, or hardly any beside those of other members
};
struct MemberMark {
    femoop::MemberId member;
    Outcome outcome = Outcome::NotDrawn;
    Score score; ///< its share counts whatever the outcome is
};

/// A prediction held against the moments of one case. Every member counts alike; those without moments on which nothing
/// was drawn do not count.
struct Assessment {
    std::vector<MemberMark> members; ///< those that count
    double share = 0.0;              ///< of all points, 0 to 1
};

/// Nothing where nothing was drawn, or the results are not those of a plane frame or lack the case.
std::optional<Assessment> assess(const Prediction& prediction, const femoop::Results& results, femoop::CaseId shown);

} // namespace frame
