#include "apps/frame/session/session.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "apps/drawing/results/envelope_cases.h"
#include "apps/drawing/results/locked_scale.h"
#include "apps/drawing/sketch/table_units.h"
#include "apps/frame/document/companion/companion_file.h"
#include "apps/frame/document/coordinate_limit.h"
#include "apps/frame/document/dropped_references.h"
#include "apps/frame/document/fault/place.h"
#include "apps/frame/document/fault/sentence.h"
#include "apps/frame/document/number.h"
#include "apps/frame/session/free_body_commands.h"
#include "apps/frame/session/transform.h"
#include "apps/frame/session/truss_commands.h"
#include "femoop/files/whole_file.h"
#include "femoop/io/counting/counting_text.h"
#include "femoop/io/free_body/free_body_text.h"
#include "femoop/io/funicular/funicular_text.h"
#include "femoop/io/model_file.h"
#include "femoop/io/results/difference_text.h"
#include "femoop/io/results/results_table.h"
#include "femoop/io/virtual_work/virtual_work_text.h"
#include "femoop/model/check/check.h"
#include "femoop/model/fault/errors_among.h"
#include "femoop/result/describe.h"
#include "femoop/result/structure_words.h"
#include "ui/files/view_file.h"
#include "ui/text/catalogue.h"
#include "ui/text/language_manner.h"
#include "ui/text/shortened.h"
#include "ui/workbench/file_sentences.h"

namespace frame {

using ui::translatable;

namespace {

std::uint64_t next_number()
{
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

} // namespace

Notice refusal_of(std::vector<femoop::Fault> faults)
{
    return about_model(translatable("nothing was changed, since the model would have an error"), std::move(faults));
}

Notice about_model(ui::Message sentence, std::vector<femoop::Fault> faults)
{
    return {ui::lasting(std::move(sentence)), std::move(faults), std::nullopt, true};
}

Session::Session(Document document) : EditedDocument(document), number_(next_number()) { restart(std::move(document)); }

void Session::restart(Document document)
{
    begin(std::move(document));
    shown_at_.clear();
    selection.clear();
    prediction.clear();
    influence.clear();
    free_body.clear();
    funicular.clear();
    virtual_work.clear();
    truss.close();
    view.load_case = femoop::CaseId(0);
    draw_state.camera.reset();
    shown_view.reset();
    look_at.reset();
    draw_state.locked_scale.reset();
    reference.reset();
    view.is_envelope = false;
    view.left_out.clear();
    mechanism = 0;
    refresh();
}

void Session::refresh()
{
    solution_ = solve(document());
    is_dirty_ = differs_from_saved();
    ++generation_;
    const auto is_lost = [this](const Cut& cut) {
        return cut.member.index >= model().members.size() || !solution_.results ||
               cut.x > solution_.results->geometry(cut.member).length;
    };
    if (pin && is_lost(*pin)) pin.reset();
    if (hover && is_lost(*hover)) hover.reset();
    if (view.load_case.index >= model().n_cases()) view.load_case = femoop::CaseId(0);
    if (mechanism >= shown_mechanisms().size()) mechanism = 0;
}

bool Session::change_soundly(const Change& wanted)
{
    Outcome outcome = outcome_of(wanted);
    if (refuse(outcome)) return false;
    std::vector<femoop::Fault> faults = named(femoop::check(outcome.document.model), outcome.document.model);
    std::erase_if(faults, [&](const femoop::Fault& fault) {
        return !is_error(fault) || std::ranges::find(solution_.faults, fault) != solution_.faults.end();
    });
    const bool is_sound = faults.empty();
    if (is_sound) accept(wanted, std::move(outcome));
    else notice = refusal_of(std::move(faults));
    return is_sound;
}

std::optional<ui::Message> Session::change(const Change& change)
{
    Outcome outcome = outcome_of(change);
    if (refuse(outcome)) return outcome.objection;
    accept(change, std::move(outcome));
    return std::nullopt;
}

bool Session::refuse(const Outcome& outcome)
{
    if (outcome.objection) notify(*outcome.objection);
    return outcome.objection.has_value();
}

// What a gesture joins in passing comes apart again, so all of it starts from what was before the gesture.
Session::Outcome Session::outcome_of(const Change& change) const
{
    const bool goes_on = change.step == Step::Drag && history_.is_dragging();
    const Document& from = change.step == Step::Drag ? history_.settled() : document();
    Outcome outcome{from, goes_on ? before_gesture_ : Companions{selection, prediction}};
    Document& next = outcome.document;
    change.command(next);
    if (change.after_selecting) {
        outcome.companions.selection = latest(next.model, from.model.nodes.size(), from.model.members.size());
        change.after_selecting(next, outcome.companions.selection);
    } else {
        outcome.companions.selection.follow(from, next);
    }
    outcome.companions.prediction.follow(from.model, next.model);
    if (!next.companion.is_empty()) frame::follow(next.companion, from.model, next.model);
    outcome.objection = why_beyond_coordinate_limit(from.model, next.model);
    return outcome;
}

void Session::accept(const Change& change, Outcome outcome)
{
    const bool begins = change.step == Step::Drag && !history_.is_dragging();
    if (begins) before_gesture_ = {selection, prediction};
    const bool is_new = outcome.document != document();
    if (is_new || change.after_selecting) selection = std::move(outcome.companions.selection);
    if (is_new) prediction = std::move(outcome.companions.prediction);
    hold_scales(change.step);
    if (is_new && (begins || change.step == Step::Click)) remember_shown();
    follow_case(model(), outcome.document.model);
    if (change.step == Step::Click) {
        notify_dropped(model(), outcome.document.model);
        history_.apply(std::move(outcome.document), change.label);
    }
    if (change.step == Step::Drag) history_.drag(std::move(outcome.document), change.label);
    if (is_new) refresh();
}

// The document has gone on from a former state.
void Session::follow(const Document& before)
{
    selection.follow(before, document());
    prediction.follow(before.model, model());
    follow_case(before.model, model());
    show_as_remembered(before.model);
    forget_notice();
    refresh();
}

void Session::forget_notice()
{
    if (notice && (notice->seconds_left || notice->is_about_model)) notice.reset();
}

namespace {

bool has_as_many_cases(const femoop::Model& a, const femoop::Model& b)
{
    return a.load_cases.size() == b.load_cases.size() && a.n_cases() == b.n_cases();
}

} // namespace

void Session::remember_shown()
{
    if (view.load_case.index < model().n_cases())
        shown_at_[history_.place()] = {model().case_name(view.load_case), view.is_envelope};
    else shown_at_.erase(history_.place());
}

void Session::show_as_remembered(const femoop::Model& before)
{
    const auto remembered = shown_at_.find(history_.place());
    if (has_as_many_cases(before, model()) || remembered == shown_at_.end()) return;
    const std::optional<femoop::CaseId> there = model().find_case(remembered->second.load_case);
    if (!there) return;
    view.load_case = *there;
    view.is_envelope = remembered->second.is_envelope;
}

// Where it is gone the one that takes its place is shown, a load case for a load case.
void Session::follow_case(const femoop::Model& before, const femoop::Model& after)
{
    const std::size_t shown = view.load_case.index, n = after.load_cases.size(), n_before = before.load_cases.size();
    if (has_as_many_cases(before, after) || shown >= before.n_cases()) return;
    const auto last_of = [](std::size_t count) { return std::max<std::size_t>(count, 1) - 1; };
    if (const auto there = after.find_case(before.case_name(view.load_case))) view.load_case = *there;
    else if (shown < n_before) view.load_case = femoop::CaseId(std::min(shown, last_of(n)));
    else view.load_case = femoop::CaseId(std::min(shown - n_before + n, last_of(after.n_cases())));
}

void Session::hold_scales(Step step)
{
    if (step == Step::Click) draw_state.locked_scale.reset();
    else if (!history_.is_dragging() && solution_.results)
        draw_state.locked_scale = locked_scale(model(), *solution_.results, view.load_case);
}

void Session::notify_dropped(const femoop::Model& before, const femoop::Model& after)
{
    if (const std::optional<ui::Message> loss = dropped_references(before, after)) notify(*loss);
}

void Session::settle()
{
    if (history_.is_dragging()) notify_dropped(history_.settled().model, model());
    history_.settle();
    draw_state.locked_scale.reset();
}

void Session::cancel()
{
    if (history_.is_dragging()) {
        selection = before_gesture_.selection;
        prediction = before_gesture_.prediction;
    }
    history_.cancel();
    settle();
    refresh();
}

void Session::prepare_to_go()
{
    settle();
    remember_shown();
}

namespace {

ui::Message of_file(std::string_view sentence, const std::filesystem::path& path)
{
    return {sentence, {{"file", path.filename().string()}}};
}

Notice not_opened(const std::filesystem::path& path, std::vector<femoop::Fault> faults)
{
    return {ui::lasting(of_file(translatable("{file} was not opened"), path)), std::move(faults)};
}

// Everything in the file was understood: what is wrong is wrong with the structure alone.
bool is_understood(const femoop::ModelReading& reading)
{
    const std::vector<femoop::Fault> of_structure = femoop::check(reading.model);
    return std::ranges::all_of(reading.faults, [&](const femoop::Fault& fault) {
        return std::ranges::find(of_structure, fault) != of_structure.end();
    });
}

} // namespace

std::optional<Notice> Session::read(const std::filesystem::path& path, Purpose purpose)
{
    femoop::ModelReading reading = femoop::examine_model_file(path);
    reading.faults = errors_among(std::move(reading.faults));
    const bool can_be_mended = is_understood(reading);
    if (!reading.faults.empty() && !(purpose == Purpose::Mend && can_be_mended)) {
        Notice refusal = not_opened(path, named(std::move(reading.faults), reading.model));
        if (can_be_mended) refusal.to_mend = path;
        return refusal;
    }
    notice.reset();
    pin.reset();
    hover.reset();
    CompanionReading beside = read_companion_of(path, reading.model);
    restart({.model = std::move(reading.model), .companion = std::move(beside.companion)});
    if (!beside.faults.empty()) // the model is open all the same; what has faults is not written over: see `write_file`
        notice = {ui::lasting(of_file(translatable("{file} was not understood in full"), ui::view_path(path))),
                  std::move(beside.faults)};
    return std::nullopt;
}

void Session::refuse(const std::filesystem::path& path, const Notice& reason)
{
    notice = reason;
    if (!is_untouched())
        notice->sentence = of_file(translatable("{file} was not opened; the model you had is unchanged"), path);
}

namespace {

// Judged beside the model that it was written for, so before another takes that one's place.
bool is_companion_sound(const std::filesystem::path& model_file)
{
    std::error_code unknown;
    if (!std::filesystem::exists(ui::view_path(model_file), unknown)) return true;
    return read_companion_of(model_file, femoop::examine_model_file(model_file).model).faults.empty();
}

Notice not_saved(const std::filesystem::path& path, std::vector<femoop::Fault> faults)
{
    return {ui::lasting(of_file(translatable("{file} was not saved"), path)), std::move(faults)};
}

Notice not_saved(const std::filesystem::path& path, const std::filesystem::path& written, const std::error_code& error)
{
    return not_saved(path, {{femoop::FaultKind::FileUnwritable, {written.string(), error.message()}}});
}

} // namespace

Session::Written Session::write_file(const std::filesystem::path& path)
{
    if (ui::model_of_view(path)) {
        const auto sentence = translatable("{file} is the name of a view file; choose another for the model");
        return {false, {ui::lasting(of_file(sentence, path))}};
    }
    const bool was_sound = is_companion_sound(path);
    try {
        femoop::write_model_file(model(), path);
    } catch (const femoop::ModelError& error) {
        return {false, not_saved(path, error.faults())};
    }
    const std::filesystem::path beside = ui::view_path(path), aside = ui::free_old_path(beside);
    std::error_code error;
    if (!was_sound) std::filesystem::rename(beside, aside, error); // before another takes its place
    if (error) return {false, not_saved(beside, aside, error)};
    error = save_companion_of(path, document());
    if (error) return {false, not_saved(beside, beside, error)};
    if (was_sound) return {true, {ui::Notice{ui::saved(path)}}};
    return {true,
            {ui::lasting({translatable("{file} was not understood; it is kept as {old}"),
                          {{"file", beside.filename().string()}, {"old", aside.filename().string()}}})}};
}

std::string Session::name() const
{
    constexpr std::size_t most_letters = 40;
    return path() || model().title.empty() ? file_name() : ui::shortened(model().title, most_letters);
}

std::string Session::file_text() const { return femoop::write_model(model()); }

std::string Session::about(const ui::Catalogue& in) const { return femoop::title_and_size_text(model(), in); }

ui::UnsavedDocument Session::unsaved() const
{
    return {.document = number(),
            .state = generation(),
            .original = path(),
            .copy =
                [this] {
                    return [document = document()](const std::filesystem::path& draft) {
                        if (const std::error_code error = save_companion_of(draft, document)) return error;
                        return files::write_whole_file(draft, femoop::write_model(document.model));
                    };
                },
            .about = [this](const ui::Catalogue& in) { return about(in); }};
}

std::optional<ui::Message> Session::why_no_results() const
{
    if (hidden) return translatable("The results are hidden; H reveals them.");
    if (!solution_.results) return translatable("There are no results: see the problems.");
    if (const BlankCase* const blank = shown_blank())
        return ui::Message(translatable("Case {case} has no results: see the problems."),
                           {{"case", model().case_name(blank->id)}});
    return std::nullopt;
}

const BlankCase* Session::shown_blank() const
{
    return view.is_envelope ? nullptr : solution_.blank_case(view.load_case);
}

const femoop::Results* Session::shown_results() const
{
    return solution_.results && shown_blank() == nullptr ? &*solution_.results : nullptr;
}

const std::vector<femoop::Mechanism>& Session::shown_mechanisms() const
{
    const BlankCase* const blank = shown_blank();
    return blank ? blank->mechanisms : solution_.mechanisms;
}

DrawOptions Session::results_view() const
{
    DrawOptions shown = view;
    for (const BlankCase& one : solution_.blank) shown.left_out.insert(model().case_name(one.id));
    return shown;
}

std::optional<femoop::Results> Session::described_results() const { return hidden ? std::nullopt : solution_.results; }

const drawing::InfluencePicture* Session::shown_line() const
{
    const drawing::InfluencePicture* const line = influence.picture(model(), generation(), view);
    return line != nullptr && hidden ? &influence.concealed() : line;
}

ui::DisplayUnits Session::units() const { return drawing::display_units(model(), view); }

void Session::set_language(ui::Language language)
{
    view.tr = ui::Catalogue(language);
    view.numbers.mark = ui::decimal_mark(language);
}

namespace {

/// Of the degree of indeterminacy, where it is shown.
std::string counting_text(const Session& session)
{
    if (!session.view.show.contains(Show::Counting)) return {};
    const auto* const counting = session.counting.of(session.model(), session.generation());
    return counting ? "\n" + femoop::counting::counting_text(*counting, session.model(), session.tr()) : "";
}

/// Of the free body, where one is lifted out.
std::string free_body_text(const Session& session)
{
    const auto* const body = lifted_body(session);
    if (body == nullptr) return {};
    return "\n" + femoop::free_body::free_body_text(body->lifted, session.model(), body->about, session.tr());
}

/// Of the funicular, or why there is none.
std::string funicular_text(const Session& session)
{
    if (!session.funicular.is_on(session.model()) || session.view.is_envelope) return {};
    const ui::Catalogue& tr = session.view.tr;
    const auto* const shown = session.funicular.picture(session.model(), session.generation(), session.view);
    if (shown == nullptr)
        return "\n" + tr("No funicular: {reason}.", {{"reason", session.funicular.why_none()}}) + "\n";
    return "\n" + femoop::funicular::funicular_text(shown->funicular, shown->chain, session.model(), tr);
}

/// Of the displacement by virtual work, or why there is none.
std::string virtual_work_text(const Session& session)
{
    const AskedWork& asked = session.virtual_work;
    if (!asked.is_on(session.model()) || session.view.is_envelope || session.shown_results() == nullptr) return {};
    const auto* const shown = asked.picture(session.model(), session.solution(), session.generation(), session.view);
    if (shown == nullptr)
        return "\n" + session.tr()("No virtual work: {reason}.", {{"reason", asked.why_none()}}) + "\n";
    return "\n" + femoop::virtual_work::virtual_work_text(shown->work, session.model(), session.tr());
}

/// What changes most from the results that are kept.
std::string comparison_text(const Session& session, const DrawOptions& shown)
{
    const femoop::Results* const results = session.shown_results();
    if (results == nullptr || shown.is_envelope || !session.reference) return {};
    const drawing::ReferenceResults& reference = *session.reference;
    const auto counterpart = reference.counterpart(session.model(), shown.load_case);
    const auto solved = session.solution().solved_cases();
    if (!counterpart || std::ranges::find(solved, shown.load_case) == solved.end()) return {};
    const ui::Catalogue& tr = shown.tr;
    const std::string name = reference.name.empty() ? tr("the results that were kept") : reference.name;
    return "\n" + session.model().case_name(shown.load_case) + ": " + tr("Compared with {name}", {{"name", name}}) +
           "\n" +
           femoop::differences_sentences({&session.model(), (*results)[shown.load_case]},
                                         {&reference.model, reference.results[*counterpart]},
                                         drawing::table_units(session.units()), tr);
}

/// Of trains, or why there is none.
std::string train_envelope_text(const Session& session)
{
    const DrawOptions shown = session.results_view();
    const AskedEnvelope& envelope = session.train_envelope;
    if (envelope.whole_picture(session.model(), session.generation(), shown) != nullptr) return envelope.words(shown);
    std::string reasons;
    for (const std::string& reason : envelope.why_none(shown.tr)) reasons += reason + "\n";
    return reasons;
}

/// What its stage shows, and what each bar that is found by then carries; or why there is none.
std::string truss_text(const Session& session)
{
    const TrussPicture* const shown = session.truss.picture(session.model(), session.shown_results(),
                                                            session.generation(), session.view);
    if (shown == nullptr) {
        const std::string reason = why_no_truss_picture(session);
        return reason.empty() ? reason : reason + "\n";
    }
    std::string text = method_name(shown->method, session.view.tr) + "\n";
    for (const std::string& line : shown->stage().lines) text += line + "\n";
    for (std::size_t i = 0; i < shown->truss.bars.size(); ++i)
        if (shown->is_found(femoop::MemberId(i))) text += shown->bar_sentences[i] + "\n";
    return text;
}

} // namespace

std::string description(const Session& session)
{
    const DrawOptions shown = session.results_view();
    const ui::Catalogue& tr = shown.tr;
    const std::optional<femoop::Results> told = session.described_results();
    if (!told) {
        const std::string words = femoop::describe(session.model(), told, tr);
        std::string reasons = "\n" + tr(*session.why_no_results()) + "\n";
        if (session.hidden) return words + reasons;
        for (const femoop::Fault& fault : session.solution().faults) reasons += sentence(fault, tr) + "\n";
        return words + reasons + counting_text(session);
    }
    std::string words = femoop::describe(session.model(), *told, session.solution().solved_cases(), tr);
    for (const femoop::Fault& warning : told->warnings())
        words += "\n" + tr("warning") + ": " + femoop::message(warning, tr) + "\n";
    for (const BlankCase& one : session.solution().blank) {
        words += "\n" + tr("Case {case} has no results.", {{"case", session.model().case_name(one.id)}}) + "\n";
        for (const femoop::Fault& fault : one.faults) words += sentence(fault, tr) + "\n";
    }
    words += comparison_text(session, shown);
    words += counting_text(session) + free_body_text(session) + funicular_text(session) + virtual_work_text(session);
    if (session.truss.is_on()) words += "\n" + truss_text(session);
    if (session.shows_train_envelope()) words += "\n" + train_envelope_text(session);
    else if (shown.is_envelope)
        words += "\n" + envelope_text(session.model(), shown) + "\n" +
                 femoop::envelope_text(session.model(), *told, envelope_cases(session.model(), shown), tr);
    if (session.influence.picture(session.model(), session.generation(), shown) != nullptr)
        words += "\n" + session.influence.words(shown);
    return words;
}

std::vector<std::string> notice_lines(const Session& session)
{
    std::vector<std::string> lines{session.tr()(session.notice->sentence)};
    for (const femoop::Fault& fault : session.notice->faults) lines.push_back(femoop::message(fault, session.tr()));
    return lines;
}

bool ends_headless(const Session& session) { return !session.path(); }

} // namespace frame
