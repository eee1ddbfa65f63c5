#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "apps/frame/predict/score.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/methods/influence/load_path.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace frame {

/// What is sketched: the bending moments of a case, or the influence line of an effect.
using PredictedSubject = std::variant<femoop::CaseId, femoop::MovingEffect>;

/// What a class sketches of the bending moments of a plane frame, or of an influence line, before it sees them. It is
/// no part of the document: it is not saved, nor undone, and belongs to the tab that it was drawn in.
class Prediction {
public:
    /// Draws on a member of the model, of what is shown. The first stroke of all says what the whole is about; one of a
    /// line after those of moments, or the other way, begins anew.
    void draw(const femoop::Model& model, const PredictedSubject& shown, femoop::MemberId member,
              std::span<const StrokePoint> stroke);
    const Guess* on(femoop::MemberId member) const; ///< null where nothing is drawn
    bool is_empty() const { return guesses_.empty(); }
    void clear() { *this = {}; }

    /// Goes on from one state of a model to the next: members are known by their names; those that are gone are
    /// dropped.
    void follow(const femoop::Model& before, const femoop::Model& after);
    /// It was drawn for another state of the model, or another case or effect.
    bool is_stale(const femoop::Model& model, const PredictedSubject& shown) const;
    bool is_of_line() const { return std::holds_alternative<femoop::MovingEffect>(subject_); }

private:
    struct Entry {
        femoop::MemberId member;
        Guess guess;
    };
    std::vector<Entry> guesses_;
    std::optional<femoop::Model> drawn_for_;
    PredictedSubject subject_;
};

/// What became of the guess on one member.
enum class Outcome : std::uint8_t {
    Judged,
    NotDrawn,    ///< though there is something
    DrawnAsZero, ///< though there is something
    NotZero,     ///< though there is nothing
    RightlyZero  ///< nothing, or hardly anything beside what other members have
};
struct MemberMark {
    femoop::MemberId member;
    Outcome outcome = Outcome::NotDrawn;
    Score score; ///< its share counts whatever the outcome is
};

/// A prediction held against the moments of one case, or an influence line. Every member counts alike; those without
/// any on which nothing was drawn do not count.
struct Assessment {
    std::vector<MemberMark> members; ///< those that count
    double share = 0.0;              ///< of all points, 0 to 1
    bool is_of_line = false;
};

/// Nothing where no moments were drawn, or the results are not those of a plane frame or lack the case.
std::optional<Assessment> assess(const Prediction& prediction, const femoop::Results& results, femoop::CaseId shown);
/// Nothing where no line was drawn. The members that count are those of the path.
std::optional<Assessment> assess(const Prediction& prediction, const femoop::influence::InfluenceLine& line,
                                 const femoop::influence::PathLayout& path);

} // namespace frame
