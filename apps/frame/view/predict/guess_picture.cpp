#include "apps/frame/view/predict/guess_picture.h"

#include <algorithm>
#include <cmath>

#include "apps/frame/view/predict/score_words.h"

namespace frame {

using femoop::MemberComponent;
using femoop::MemberId;

namespace {

/// Draws the guess on one member.
class MemberGuess {
public:
    MemberGuess(const Scene& scene, MemberId id, const SymbolFrame& frame, const Guess& guess, double scale)
        : scene_(scene),
          id_(id),
          guess_(guess),
          frame_(frame),
          length_(scene.shape[id].length * scene.projection.scale()),
          height_(scene.shape[id].length * scale)
    {}

    void draw() const
    {
        for (std::size_t begin = 0; begin < Guess::n_places; ++begin) {
            std::size_t end = begin;
            while (end < Guess::n_places && guess_[end]) ++end;
            if (end > begin + 1) draw_run(begin, end);
            begin = end;
        }
    }

    void write(const std::string& words) const
    {
        std::size_t highest = Guess::n_places / 2;
        for (std::size_t i = kept_off(0); i + kept_off(1) < Guess::n_places; ++i)
            if (std::abs(value(i)) > std::abs(value(highest))) highest = i;
        Caption caption{.text = words,
                        .role = ui::Role::Guess,
                        .target = at(highest),
                        .toward = value(highest) < 0.0 ? -frame_.y : frame_.y,
                        .gap = 6.0,
                        .rank = Rank::Extreme,
                        .weight = ui::Weight::Bold};
        for (const std::size_t i : {60U, 120U, 180U, 30U, 210U}) caption.others.push_back(at(i));
        scene_.sketch.caption(std::move(caption));
    }

private:
    /// Places at an end that a support has: a mark there would seem to be the support's.
    std::size_t kept_off(std::size_t end) const
    {
        const femoop::NodeId node = scene_.model[id_].nodes.at(end);
        return scene_.model[node].support ? Guess::n_places / 8 : 0;
    }
    double value(std::size_t place) const { return guess_[place].value_or(0.0); }
    ui::Point foot(std::size_t place) const { return frame_(Guess::x(place) * length_, 0.0); }
    ui::Point at(std::size_t place) const { return frame_(Guess::x(place) * length_, value(place) * height_); }

    void draw_run(std::size_t begin, std::size_t end) const
    {
        Sketch& sketch = scene_.sketch;
        std::vector<ui::Point> line;
        for (std::size_t i = begin; i < end; ++i) line.push_back(at(i));
        std::vector<ui::Point> area = line;
        area.push_back(foot(end - 1));
        area.push_back(foot(begin));
        {
            const ui::LayerScope layer(sketch.painter(), ui::Layer::Areas);
            sketch.polygon(area, ui::with_opacity(sketch.stroke(ui::Role::Guess).color, 0.10), Clearance::Soft);
        }
        sketch.polyline(line, sketch.stroke(ui::Role::Guess), Clearance::Hard);
        const ui::Stroke closing = sketch.thin(ui::Role::Guess);
        if (begin == 0) sketch.line(foot(begin), at(begin), closing);
        if (end == Guess::n_places) sketch.line(foot(end - 1), at(end - 1), closing);
    }

    const Scene& scene_;
    MemberId id_;
    const Guess& guess_;
    SymbolFrame frame_;
    double length_, height_; ///< of the member, and of an ordinate of its length [px]
};

} // namespace

const MemberMark* GuessPicture::mark_of(MemberId member) const
{
    if (!assessment_) return nullptr;
    const auto found = std::ranges::find(assessment_->members, member, &MemberMark::member);
    return found != assessment_->members.end() ? &*found : nullptr;
}

// Logical pixels of an ordinate as long as the model's unit of length.
double GuessPicture::scale_beside(const Scene& scene, const SolvedCase& solved, const Diagram& moments) const
{
    double drawn = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < scene.shape.members.size(); ++i) {
        const Guess* const guess = prediction_.on(MemberId(i));
        if (guess == nullptr) continue;
        const femoop::Extremes extremes = solved.curves[i].extremes(MemberComponent::Mz);
        drawn = std::max(drawn, guess->largest() * scene.shape.members[i].length);
        moment = std::max({moment, std::abs(extremes.max.value), std::abs(extremes.min.value)});
    }
    const double height = moment * moments.pixels_per_unit;
    return drawn > 0.0 && height > 0.0 ? height / drawn : scene.projection.scale();
}

void GuessPicture::draw(const Scene& scene, const FrameOf& frame_of, double scale) const
{
    for (std::size_t i = 0; i < scene.shape.members.size(); ++i) {
        const Guess* const guess = prediction_.on(MemberId(i));
        if (guess == nullptr) continue;
        const MemberGuess picture(scene, MemberId(i), frame_of(scene.shape.members[i]), *guess, scale);
        picture.draw();
        if (const MemberMark* const mark = mark_of(MemberId(i)))
            picture.write(scene.model[MemberId(i)].id + ": " + percent(mark->score.share, scene.options.tr));
    }
}

void GuessPicture::draw_moments(const Scene& scene, double scale) const
{
    draw(
        scene, [&](const MemberShape& member) { return diagram_frame(scene, member, MemberComponent::Mz); }, scale);
}

void GuessPicture::draw_alone(const Scene& scene) const { draw_moments(scene, scene.projection.scale()); }

void GuessPicture::draw_beside(const Scene& scene, const SolvedCase& solved, const Diagram& moments) const
{
    draw_moments(scene, scale_beside(scene, solved, moments));
}

void GuessPicture::draw_on_line(const Scene& scene, const InfluencePicture& line, const InfluenceScale& scale) const
{
    double drawn = 0.0;
    for (const auto& on : line.path.members)
        if (const Guess* const guess = prediction_.on(on.member)) drawn = std::max(drawn, guess->largest() * on.length);
    const double height = scale.largest * scale.pixels_per_unit;
    const bool is_hidden = is_concealed(line) && line.forces.empty(); // no load has begun to draw it
    const bool is_seen = !is_hidden && drawn > 0.0 && height > 0.0;
    const auto frame_of = [&](const MemberShape& member) {
        return scene.projection.frame(member.at(0.0), member.x(), ordinate_side(line.load, member, scene.is_flat()));
    };
    draw(scene, frame_of, is_seen ? height / drawn : scene.projection.scale());
}

bool GuessPicture::is_stale(const Scene& scene) const
{
    if (line_) return line_->is_stale; // a load may stand on the scene's model that is none of the document's
    return prediction_.is_stale(scene.model, scene.options.load_case);
}

PanelHead GuessPicture::head(const Scene& scene) const
{
    const ui::Catalogue& tr = scene.options.tr;
    PanelHead head{
        .name = line_ ? tr("Your guess of the line") : tr("Your guess of M"), .note = {}, .role = ui::Role::Guess};
    if (!line_ && scene.options.is_envelope) head.note = tr("an envelope is no diagram of one case; choose a case");
    else if (is_stale(scene))
        head.note = line_ ? tr("drawn for another state of the model, or another line")
                          : tr("drawn for another state of the model, or another load case");
    else if (assessment_ || (line_ && line_->is_traced)) head.note = tr("dashed, as high as the true diagram");
    else head.note = tr("H reveals the true diagram");
    return head;
}

std::vector<std::string> GuessPicture::foot(const TextContext& context) const
{
    if (!assessment_) return {};
    return ScoreWords{context.model, context.shape, context.units, context.tr}.lines(*assessment_);
}

} // namespace frame
