#include "apps/drawing/truss/truss_picture.h"

#include "femoop/io/truss/truss_sentence.h"
#include "femoop/io/truss/truss_step.h"
#include "femoop/methods/truss/zero_force.h"

#include <algorithm>

namespace drawing {

namespace {

using femoop::MemberId;
using femoop::truss::DiagramStep;
using femoop::truss::Step;
using femoop::truss::StepKind;

/// Puts the stages of one method together.
class StageMaker {
public:
    StageMaker(TrussPicture& picture, const femoop::Model& model, const ui::Catalogue& tr)
        : picture_(picture), model_(model), tr_(tr)
    {
        picture_.bar_sentences.resize(picture_.truss.bars.size());
    }

    void make()
    {
        switch (picture_.method) {
        case TrussMethod::ZeroForces: find_zero_forces(); break;
        case TrussMethod::Joints: go_joint_by_joint(); break;
        case TrussMethod::Cremona: draw_bar_by_bar(); break;
        }
        const std::string n = std::to_string(picture_.stages.size());
        for (std::size_t i = 0; i < picture_.stages.size(); ++i) {
            TrussStage& stage = picture_.stages[i];
            const std::string number = std::to_string(i + 1) + "/" + n + "  ";
            stage.title = number + (stage.title.empty() ? stage.lines.front() : stage.title);
            stage.lines.front().insert(0, number);
        }
        picture_.n_stages = picture_.stages.size();
    }

private:
    /// At last all of them, counted.
    void find_zero_forces()
    {
        for (const auto& step : zero_force_steps(picture_.truss)) {
            TrussStage stage{.lines = {}, .joint = step.front().joint};
            for (const femoop::truss::ZeroForceBar& bar : step) {
                stage.lit.push_back(bar.bar);
                picture_.bar_sentences[bar.bar.index] = sentence(bar, model_, tr_);
                stage.lines.push_back(picture_.bar_sentences[bar.bar.index]);
            }
            stage.found = stage.lit;
            picture_.stages.push_back(std::move(stage));
        }
        picture_.stages.push_back({.lines = {zero_force_summary(picture_.truss, model_, tr_)}});
    }

    /// First what is unknown at a joint, then what its equations give.
    void go_joint_by_joint()
    {
        for (std::size_t i = 0; i < picture_.joints.steps.size(); ++i) {
            const Step& step = picture_.joints.steps[i];
            femoop::truss::StepText text = step_text(step, picture_.truss, model_, tr_);
            TrussStage stage{.lines = text.question, .joint = step.joint, .step = i};
            if (step.cut) stage.ritter_point = step.cut->equations.front().ritter_point;
            stage.lit = step.cut ? step.cut->bars : step.found;
            if (!text.question.empty()) picture_.stages.push_back(stage);
            if (text.answer.empty()) continue;
            stage.lines.insert(stage.lines.end(), text.answer.begin(), text.answer.end());
            stage.found = step.found;
            stage.title = text.answer.front();
            picture_.stages.push_back(std::move(stage));
            for (const MemberId bar : step.found) picture_.bar_sentences[bar.index] = text.answer.front();
        }
    }

    void draw_bar_by_bar()
    {
        const femoop::truss::Reciprocal& diagram = *picture_.diagram;
        for (const DiagramStep& step : diagram.steps) {
            TrussStage stage{.lines = stage_lines(step, picture_.truss, diagram, model_, tr_)};
            if (step.joint_step) stage.joint = diagram.joints.steps[*step.joint_step].joint;
            if (step.bar) stage.lit.push_back(*step.bar);
            if (step.bar && !step.is_open) stage.found.push_back(*step.bar);
            if (step.cuts) stage.found.push_back(*step.cuts);
            picture_.stages.push_back(std::move(stage));
        }
        for (std::size_t i = 0; i < picture_.truss.bars.size(); ++i)
            picture_.bar_sentences[i] = reading_sentence(picture_.truss, diagram, MemberId(i), model_, tr_);
    }

    TrussPicture& picture_;
    const femoop::Model& model_;
    const ui::Catalogue& tr_;
};

} // namespace

bool TrussPicture::is_found(MemberId bar) const
{
    return std::any_of(stages.begin(), stages.begin() + static_cast<std::ptrdiff_t>(n_stages),
                       [&](const auto& one) { return std::ranges::find(one.found, bar) != one.found.end(); });
}

std::optional<femoop::truss::Refusal> why_not(TrussMethod method, const femoop::truss::Truss& truss)
{
    return method == TrussMethod::Cremona ? why_no_reciprocal(truss) : std::nullopt;
}

TrussPicture truss_picture(TrussMethod method, const femoop::Model& model, const femoop::truss::Truss& truss,
                           const ui::Catalogue& tr)
{
    TrussPicture picture{.method = method, .truss = truss, .arrangement = usual_arrangement(truss)};
    if (method == TrussMethod::Cremona) picture.diagram = reciprocal(truss);
    picture.joints = picture.diagram ? picture.diagram->joints : joint_method(truss, picture.arrangement);
    StageMaker(picture, model, tr).make();
    return picture;
}

} // namespace drawing
