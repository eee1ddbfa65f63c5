#include "apps/plane/session/session.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <future>
#include <numbers>
#include <utility>
#include <variant>

#include "apps/drawing/quantity_typed.h"
#include "apps/plane/backdrop/view_file.h"
#include "apps/plane/document/fault_words.h"
#include "apps/plane/document/insertion.h"
#include "apps/plane/document/points.h"
#include "apps/plane/document/regions.h"
#include "apps/plane/outline/outline.h"
#include "apps/plane/view/error_curve.h"
#include "apps/plane/view/field_picture.h"
#include "apps/plane/view/plate_scene.h"
#include "femoop/files/whole_file.h"
#include "femoop/io/any_model.h"
#include "femoop/io/plane/plane_file.h"
#include "femoop/plane/check/plane_check.h"
#include "topology/text/line_error.h"
#include "ui/files/in_background.h"
#include "ui/files/view_file.h"

namespace plane {

using femoop::Fault;
using ui::Message;
using ui::translatable;

namespace {

constexpr std::uintmax_t most_bytes = 100'000'000;

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

bool are_drawn_alike(const PlaneModel& a, const PlaneModel& b)
{
    if (a.snap != b.snap || a.points.size() != b.points.size() || a.curves.size() != b.curves.size()) return false;
    for (std::size_t i = 0; i < a.points.size(); ++i)
        if (a.points[i].at != b.points[i].at) return false;
    for (std::size_t i = 0; i < a.curves.size(); ++i)
        if (a.curves[i].shape != b.curves[i].shape) return false;
    return true;
}

/// About how long meshing, solving and recovering take with this many unknowns, rounded up.
std::size_t seconds_to_solve(std::size_t n_unknowns) { return 1 + n_unknowns / 50'000; }

/// The rectangle about the drawing; of one without a width and a height that of an empty sheet.
std::array<FlatPoint, 2> room_of(const PlaneModel& model)
{
    const double width = usual_width(model);
    std::array<FlatPoint, 2> room{FlatPoint{0.0, 0.0}, FlatPoint{width, 0.6 * width}};
    if (model.points.empty()) return room;
    FlatPoint low = place_of(model, NodeId(0)), high = low;
    for (std::size_t i = 1; i < model.points.size(); ++i) {
        const FlatPoint at = place_of(model, NodeId(i));
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    return low.x < high.x && low.y < high.y ? std::array{low, high} : room;
}

/// A file that was understood, whose drawing may have errors: they are shown, to be mended.
bool is_understood(const femoop::plane::PlaneReading& reading)
{
    const std::vector<Fault> of_model = femoop::plane::check(reading.model);
    return std::ranges::all_of(reading.faults, [&](const Fault& fault) {
        return !is_error(fault) || std::ranges::find(of_model, fault) != of_model.end();
    });
}

} // namespace

Session::Session(const Document& document) : EditedDocument(document) { solve_again(); }

void Session::solve_again() { accept(std::make_shared<const Solution>(document())); }

void Session::accept(std::shared_ptr<const Solution> solution)
{
    const std::shared_ptr<const Solution> before = std::exchange(solution_, std::move(solution));
    const std::size_t n_before = before ? before->model().n_cases() : 0;
    if (load_case < n_before && n_before != model().n_cases()) // the one of the same name is shown on
        if (const auto same = model().find_case(before->model().case_name(femoop::CaseId(load_case))))
            load_case = same->index;
    gap_ = drawing() != nullptr ? narrowest_gap(*drawing()) : std::nullopt;
    load_case = std::min(load_case, std::max<std::size_t>(model().n_cases(), 1) - 1);
}

std::optional<Message> Session::change(const Change& change)
{
    const bool is_drag = change.step == Step::Drag;
    const Document& from = is_drag ? history_.settled() : document();
    const std::shared_ptr<const Solution> before = is_drag && history_.is_dragging() && settled_ ? settled_ : solution_;
    Document next = from;
    change.command(next);
    const bool has_faces = before->drawing() != nullptr && !are_drawn_alike(before->model(), next.model);
    if (has_faces) follow_faces(next, *before->drawing());
    if (next.model != from.model) next.cycle.reset(); // which is of the model as it was
    auto would_be = next.model == before->model() ? before : std::make_shared<const Solution>(next);
    if (would_be->refused().size() > before->refused().size()) {
        const Fault& fault = would_be->refused().back();
        return Message(sentence(fault, next.model, tr()));
    }
    const PlaneModel was = model();
    stop_refining();
    if (is_drag) {
        if (!history_.is_dragging()) settled_ = solution_;
        history_.drag(std::move(next), change.label);
    } else {
        history_.apply(std::move(next), change.label);
    }
    accept(std::move(would_be));
    keep_selection(was);
    return std::nullopt;
}

void Session::settle()
{
    history_.settle();
    settled_.reset();
}

void Session::cancel()
{
    const PlaneModel was = model();
    history_.cancel();
    settled_.reset();
    solve_again();
    keep_selection(was);
}

void Session::follow(const Document& before)
{
    stop_refining();
    settled_.reset();
    solve_again();
    keep_selection(before.model);
}

namespace {

/// The entry of the same name, where its list has it still.
template <class Id, class Entries> std::optional<Part> same_entry(Id id, const Entries& before, const Entries& now)
{
    if (id.index >= before.size()) return std::nullopt;
    if (before.size() == now.size()) return id; // none has come or gone: it may have another name
    if (id.index < now.size() && now[id.index].id == before[id.index].id) return id;
    for (std::size_t i = 0; i < now.size(); ++i)
        if (now[i].id == before[id.index].id) return Id(i);
    return std::nullopt;
}

} // namespace

// What is selected is known by its name, a face by a place in it.
void Session::keep_selection(const PlaneModel& before)
{
    std::vector<Part> kept;
    for (const Part& part : selection_) {
        std::optional<Part> now = part;
        if (const auto* const point = std::get_if<NodeId>(&part))
            now = same_entry(*point, before.points, model().points);
        if (const auto* const curve = std::get_if<CurveId>(&part))
            now = same_entry(*curve, before.curves, model().curves);
        if (const auto* const face = std::get_if<FacePlace>(&part); face != nullptr && !face_of(*face)) now.reset();
        if (now) kept.push_back(*now);
    }
    selection_ = std::move(kept);
    hover.reset();
}

void Session::restart(Document document)
{
    begin(std::move(document));
    ++opening_;
    settled_.reset();
    selection_.clear();
    hover.reset();
    watch.end();
    stop_refining();
    forget_results();
    camera.reset();
    left_gap_.reset();
    look.readings = {};
    solve_again();
    load_case = 0;
}

void Session::new_document() { restart(plane::new_document()); }

void Session::show_example(Document document) { restart(std::move(document)); }

std::optional<ui::Notice> Session::read(const std::filesystem::path& path)
{
    const files::WholeFile file = files::read_whole_file(path, most_bytes);
    if (file.hindrance) return ui::lasting(ui::not_opened(path, file.hindrance));
    femoop::plane::PlaneReading reading = femoop::plane::examine_plane_model(file.text);
    if (!is_understood(reading)) {
        const femoop::AnyReading any = femoop::examine_any(file.text);
        if (const auto* members = std::get_if<femoop::ModelReading>(&any); members && members->is_sound())
            return ui::lasting(
                ui::not_opened(path, Message(translatable("it holds a structure of members; the frame app opens it"))));
        std::erase_if(reading.faults, [](const Fault& fault) { return !is_error(fault); });
        return ui::lasting(ui::not_opened(path, sentences_of(reading.faults)));
    }
    if (!reading.model.is_drawn)
        return ui::lasting(ui::not_opened(
            path, Message(translatable("it holds a mesh of elements; this app opens drawings of curves"))));
    ViewReading beside = read_view_of(path);
    restart({.model = std::move(reading.model), .backdrop = std::move(beside.backdrop)});
    if (!beside.faults.empty()) // the drawing is open all the same; what has faults is not written over
        notice = ui::lasting(ui::not_opened(ui::view_path(path), sentences_of(beside.faults)));
    return std::nullopt;
}

std::vector<Message> Session::sentences_of(const std::vector<Fault>& faults) const
{
    std::vector<Message> sentences;
    for (const Fault& fault : faults)
        sentences.emplace_back(femoop::message(fault, [this](std::string_view text) { return tr()(text); }));
    return sentences;
}

Session::Written Session::write_file(const std::filesystem::path& path)
{
    if (ui::model_of_view(path))
        return {false, ui::lasting({translatable("{file} is the name of a view file; choose another for the model"),
                                    {{"file", path.filename().string()}}})};
    Written written = EditedDocument::write_file(path);
    if (!written.is_whole) return written;
    const SavedView beside = save_view_of(path, document().backdrop);
    const std::filesystem::path view = ui::view_path(path);
    if (beside.hindrance) return {false, ui::lasting(ui::not_saved(view, beside.hindrance))};
    if (beside.put_aside)
        written.notice = ui::lasting(
            {translatable("{file} was not understood; it is kept as {old}"),
             {{"file", view.filename().string()}, {"old", beside.put_aside->filename().string()}}});
    return written;
}

/// A draft has a view file of its own beside it.
ui::UnsavedDocument Session::unsaved() const
{
    ui::UnsavedDocument unsaved = EditedDocument::unsaved();
    const std::optional<Backdrop>& backdrop = document().backdrop;
    constexpr std::uint64_t odd = 0x9E3779B97F4A7C15; // 2^64 over the golden ratio
    if (backdrop) unsaved.state ^= odd * std::hash<std::string>()(view_text(*backdrop, {}));
    unsaved.copy = [backdrop, copy = unsaved.copy] {
        return [backdrop, write = copy()](const std::filesystem::path& draft) {
            const std::error_code hindrance = write_view_of(draft, backdrop);
            return hindrance ? hindrance : write(draft);
        };
    };
    return unsaved;
}

namespace {

/// What of an outline's file was taken otherwise than it stands there.
Message notice_of(const outline::Outline& outline, const femoop::Units& units, std::size_t n_curves,
                  const ui::Catalogue& tr)
{
    std::string told = tr(translatable("curves: {n}"), {{"n", std::to_string(n_curves)}});
    if (!outline.unit)
        told += "; " + tr(translatable("the file has no unit; its numbers are taken as {unit}"),
                          {{"unit", std::string(femoop::name(units.length))}});
    if (!outline.left_out.empty())
        told += "; " + tr(translatable("left out: {what}"), {{"what", outline::left_out_text(outline)}});
    return Message(translatable("Inserted: {what}"), {{"what", told}});
}

} // namespace

template <class Reason> bool Session::refuse(const std::filesystem::path& path, const Reason& reason)
{
    notice = ui::lasting(ui::not_opened(path, reason));
    return false;
}

bool Session::insert_outline(const std::filesystem::path& path)
{
    const files::WholeFile file = files::read_whole_file(path, most_bytes);
    if (file.hindrance) return refuse(path, file.hindrance);
    try {
        const outline::Outline outline = outline::read_outline(path, file.text);
        const PlaneModel drawing = outline::drawing_of(outline, model().units);
        if (drawing.curves.empty()) return refuse(path, Message(translatable("there is no curve in it")));
        const auto insert = [&](Document& document) { insert_drawing(document, drawing); };
        const std::string name = path.filename().string();
        if (const auto reason = change({{translatable("Insert {file}"), {{"file", name}}}, insert}))
            return refuse(path, *reason);
        notify(notice_of(outline, model().units, drawing.curves.size(), tr()));
    } catch (const topology::LineError& fault) {
        return refuse(path, Message(fault.sentence([this](std::string_view text) { return tr()(text); })));
    }
    return true;
}

bool Session::insert_backdrop(const std::filesystem::path& path)
{
    const ImageReading reading = read_image(path);
    if (reading.fault) return refuse(path, sentences_of({*reading.fault}));
    std::error_code unknown;
    const auto [low, high] = room_of(model());
    const Backdrop backdrop = backdrop_within(reading.photo,
                                              std::filesystem::absolute(path, unknown).lexically_normal(), low, high);
    look.backdrop = true;
    return !change({{translatable("Insert {file}"), {{"file", path.filename().string()}}},
                    [backdrop](Document& document) { document.backdrop = backdrop; }});
}

std::string Session::file_text() const { return femoop::plane::write_plane_model(model()); }

std::string Session::about(const ui::Catalogue& in) const
{
    return in(translatable("curves: {curves}, regions: {regions}"),
              {{"curves", std::to_string(model().curves.size())}, {"regions", std::to_string(model().regions.size())}});
}

std::string Session::name() const { return !path() && !model().title.empty() ? model().title : file_name(); }

ui::DisplayUnits Session::units() const { return display_units(model(), options()); }

// ---- mesh and results

PlateInput Session::input() const
{
    const Analysed* const found = analysed();
    const Solution& solution = found != nullptr ? *found->solution() : *solution_;
    PlateInput input{.model = solution.model(), .drawing = solution.drawing()};
    if (look.backdrop && document().backdrop) input.backdrop = &*document().backdrop;
    input.player = player();
    if (input.player != nullptr) return input;
    if (found == nullptr || found->mesh() == nullptr) return input;
    input.mesh = found->mesh();
    input.modes = modes();
    if (look.modes) return input;
    if (needs_results(look) && !found->mechanisms().empty()) input.motion = &found->mechanisms()[mechanism()].motion;
    if (found->result(load_case) == nullptr || !found->is_loaded(load_case)) return input;
    input.cycle = cycle();
    keep_beside(input);
    input.results = found->results();
    input.result = found->result(load_case);
    return input;
}

/// The kept results of the case of the same name.
void Session::keep_beside(PlateInput& input) const
{
    if (!kept_ || kept_ == analysed_) return;
    const auto same = kept_->mesh()->find_case(model().case_name(femoop::CaseId(load_case)));
    if (!same || kept_->result(same->index) == nullptr || !kept_->is_loaded(same->index)) return;
    input.kept_results = kept_->results();
    input.kept_result = kept_->result(same->index);
}

std::optional<Message> Session::keep_results()
{
    analyse_what_is_shown();
    if (const auto reason = why_no_results()) return reason;
    if (analysed() == nullptr || analysed()->result(load_case) == nullptr)
        return translatable("there are no results; show the deformed shape or a stress first");
    kept_ = analysed_;
    return std::nullopt;
}

const Analysed* Session::analysed() const
{
    const bool is_of_now = analysed_ && (analysed_->solution() == solution_ || ahead_.valid()) &&
                           (!analysed_->is_following() || history_.is_dragging());
    return is_of_now && needs_mesh(look) ? analysed_.get() : nullptr;
}

const femoop::plane::NaturalModes* Session::modes() const
{
    return look.modes && vibration_ && vibration_->of().get() == analysed() ? vibration_->modes() : nullptr;
}

std::vector<Fault> Session::faults_of_modes() const
{
    if (!look.modes || !vibration_ || vibration_->of().get() != analysed()) return {};
    return vibration_->faults();
}

void Session::analyse_what_is_shown()
{
    find_mesh_and_results();
    if (look.modes) find_modes();
}

/// While a hand drags, only where they came fast enough to follow it.
void Session::find_modes()
{
    if (analysed() == nullptr || analysed()->mesh() == nullptr) return;
    if (vibration_ && vibration_->of() == analysed_) return;
    if (history_.is_dragging() && modes_seconds_ > patience.of_a_hand) return;
    const auto start = Clock::now();
    vibration_ = std::make_shared<const Vibration>(analysed_);
    modes_seconds_ = seconds_since(start);
}

void Session::find_mesh_and_results()
{
    const bool is_dragging = history_.is_dragging();
    if (!is_dragging) stop_following();
    if (!needs_mesh(look) || !solution_->is_sound() || drawing() == nullptr) {
        ahead_ = {};
        if (run_) drop_run();
    } else if (!is_dragging || follows_slower_than(patience.behind_a_hand) || !follow_with_mesh()) find_anew();
}

/// While a hand drags, only where they came fast enough to follow it.
void Session::find_anew()
{
    ahead_ = {};
    if (run_ && run() == nullptr) drop_run();
    std::erase_if(ending_, [](const auto& run) { return run->is_done_within(0.0); });
    if (analysed() != nullptr || (history_.is_dragging() && last_seconds_ > patience.of_a_hand)) return;
    const bool is_begun = run_ != nullptr;
    if (!is_begun) {
        AnalysisRun::Limits limits;
        const bool is_waited_for = std::isinf(patience.in_a_frame) || ui::in_background() == std::launch::deferred;
        if (is_waited_for) limits.seconds = patience.at_most;
        if (insisted_ != solution_) limits.unknowns = patience.most_unknowns;
        run_ = std::make_shared<AnalysisRun>(solution_, document().sizes(), limits);
    }
    if (!run_->is_done_within(is_begun ? 0.0 : patience.in_a_frame)) {
        last_seconds_ = std::max(last_seconds_, patience.in_a_frame);
        return;
    }
    const AnalysisRun::Result found = std::exchange(run_, nullptr)->result();
    analysed_ = found.analysed;
    last_seconds_ = found.seconds;
}

/// Its thread ends by itself, while nobody waits.
void Session::drop_run()
{
    run_->give_up();
    ending_.push_back(std::exchange(run_, nullptr));
}

void Session::give_up_analysis()
{
    if (run() == nullptr) return;
    drop_run();
    analysed_ = std::make_shared<const Analysed>(Analysed::given_up(solution_));
}

bool Session::was_left() const
{
    const Analysed* const found = analysed();
    return found != nullptr && (found->was_cancelled() || found->n_unknowns_too_many());
}

void Session::analyse_all_the_same()
{
    insisted_ = solution_;
    analysed_.reset();
}

void Session::stop_following()
{
    ahead_ = {};
    dragged_.reset();
    following_.reset();
    follow_seconds_.reset();
}

/// Takes what was begun in a frame before, and begins what this frame's drawing asks for. Elements that were turned
/// inside out have the drawing meshed again, from where the hand is now.
bool Session::follow_with_mesh()
{
    if (analysed_ && !analysed_->is_following() && analysed_ != dragged_) {
        dragged_ = analysed_;
        following_.reset();
    }
    if (!dragged_ || dragged_->mesh() == nullptr) return false;
    if (ahead_.valid()) {
        if (follows_slower_than(patience.of_a_hand) && !ui::is_ready(ahead_)) return true;
        const Ahead found = std::exchange(ahead_, {}).get();
        if (found.analysed->mesh() == nullptr) return false;
        analysed_ = found.analysed;
        follow_seconds_ = std::min(found.seconds, follow_seconds_.value_or(found.seconds));
    }
    if (analysed_->solution() == solution_) return true;
    if (!following_) following_ = std::make_shared<Following>(dragged_->solution(), dragged_->meshed().mesh());
    const auto analyse = [this_solution = solution_, following = following_, shown = load_case] {
        const Clock::time_point start = Clock::now();
        auto analysed = std::make_shared<const Analysed>(this_solution, *following);
        if (const femoop::plane::PlaneCase* result = analysed->result(shown)) result->recover();
        return Ahead{std::move(analysed), seconds_since(start)};
    };
    ahead_ = std::async(ui::in_background(), analyse);
    return true;
}

std::optional<KeptRange> Session::range_of_bands() const
{
    const PlateInput now = input();
    if (!look.field || now.result == nullptr) return std::nullopt;
    const FieldPicture bands = field_picture({*look.field, FieldStyle::Bands}, *now.result, options(), units());
    return KeptRange{.component = *look.field, .low = bands.levels.front(), .high = bands.levels.back()};
}

/// The first of some faults, such as the motions of a body that is not held; how they all begin is said once.
std::string Session::told(const std::vector<Fault>& faults) const
{
    constexpr std::size_t most = 3;
    const std::string first = sentence(faults.front(), model(), tr());
    const std::string beginning = first.substr(0, first.find(": ") + 2);
    std::string all = first;
    for (std::size_t i = 1; i < std::min(most, faults.size()); ++i) {
        std::string next = sentence(faults[i], model(), tr());
        if (next.starts_with(beginning)) next.erase(0, beginning.size());
        all += "; " + next;
    }
    return all;
}

std::optional<Message> Session::why_no_results() const
{
    if (!needs_mesh(look) || history_.is_dragging()) return std::nullopt;
    const auto said = [&](const std::vector<Fault>& faults) { return Message(told(faults)); };
    if (!solution_->is_sound()) return said(solution_->faults());
    const Analysed* const found = analysed();
    if (found == nullptr) return std::nullopt;
    if (found->was_cancelled())
        return translatable("meshing and solving took too long and were given up; give a larger element size");
    if (const auto n = found->n_unknowns_too_many())
        return Message(translatable("the mesh has {n} unknowns, which take about {seconds} s, and its picture follows "
                                    "slowly; give a larger element size, or go on"),
                       {{"n", std::to_string(*n)}, {"seconds", std::to_string(seconds_to_solve(*n))}});
    if (look.modes && found->mesh() != nullptr) {
        if (!vibration_ || vibration_->of().get() != found || vibration_->modes() != nullptr) return std::nullopt;
        return said(vibration_->faults());
    }
    if (!found->faults().empty()) return said(found->faults());
    if (needs_results(look) && found->result(load_case) != nullptr && !found->is_loaded(load_case))
        return Message(translatable("load case {id} has no load, so that nothing moves; give one a value"),
                       {{"id", model().case_name(femoop::CaseId(load_case))}});
    if (needs_results(look) && found->results() == nullptr)
        return translatable("there is no load case yet; add a load to a curve or a point");
    return std::nullopt;
}

// ---- refinement by the error

std::optional<Message> Session::refine(std::size_t n_cycles)
{
    if (!solution_->is_sound()) return Message(told(solution_->faults()));
    if (const auto mapped = discretize::mapped_region(model()))
        return Message(translatable("region {region} is mapped, and its mesh follows its sides; give it the method "
                                    "delaunay or quads, or leave its method to the app"),
                       {{"region", model()[*mapped].id}});
    watch.end();
    look.mesh = true;
    if (!needs_results(look)) look.error = true;
    refinement_ = Refinement{.n_left = n_cycles};
    return std::nullopt;
}

/// One mesh a while, so that each is seen. The first one begins where the results are there.
void Session::refine_further(double seconds)
{
    constexpr double between = 0.4; // [s]
    if (!refinement_) return;
    const bool is_first = refinement_->waited == 0.0;
    refinement_->waited += seconds;
    const Analysed* const found = analysed();
    if (found == nullptr || (!is_first && refinement_->waited < between)) return;
    const auto end = refine_once();
    if (end) notify({translatable("Refinement ends here: {reason}"), {{"reason", *end}}});
    if (end || --refinement_->n_left == 0) return stop_refining();
    refinement_->waited = seconds;
}

std::optional<Message> Session::refine_once()
{
    const auto is_late = [&, start = Clock::now()] { return seconds_since(start) > patience.at_most; };
    if (const auto reason = why_no_results()) return reason;
    const femoop::CaseId shown(load_case);
    discretize::ErrorCycle cycle(shown);
    if (document().cycle && document().cycle->load_case() == shown) cycle = *document().cycle;
    if (cycle.meshes().empty()) cycle.add(*analysed_->results(), *analysed_->result(load_case));
    const discretize::NextMesh next = cycle.next();
    if (next.end) return reason_of(next, cycle);
    auto found = std::make_shared<const Analysed>(solution_, is_late, next.sizes);
    if (found->was_cancelled()) return Message(translatable("the mesh took too long and was given up"));
    if (found->result(load_case) == nullptr) return Message(told(found->faults()));
    cycle.take(next.sizes);
    cycle.add(*found->results(), *found->result(load_case));
    cycle.compare(*drawing(), is_late);
    analysed_ = std::move(found);
    Document refined = document();
    refined.cycle = std::make_shared<const discretize::ErrorCycle>(std::move(cycle));
    history_.apply(std::move(refined), translatable("Refine the mesh by the error"));
    return std::nullopt;
}

void Session::give_up_refinement()
{
    Document plain = document();
    plain.cycle.reset();
    history_.apply(std::move(plain), translatable("Give the refined mesh up"));
    stop_refining();
    solve_again();
}

namespace {

constexpr double seconds_per_swing = 2.4;

} // namespace

bool Session::is_swinging() const
{
    if (is_animated || is_still) return is_animated;
    const Analysed* const found = needs_results(look) ? analysed() : nullptr;
    return look.modes || (found != nullptr && !found->mechanisms().empty());
}

std::size_t Session::mechanism() const
{
    constexpr double swings_of_each = 2.0;
    const auto turn = static_cast<std::size_t>(swing_ / (swings_of_each * seconds_per_swing));
    return turn % analysed()->mechanisms().size();
}

void Session::tick(double seconds)
{
    ui::tick(notice, seconds);
    watch.tick(seconds);
    refine_further(seconds);
    swing_ = is_swinging() ? swing_ + seconds : 0.0;
}

double Session::phase() const { return std::cos(2.0 * std::numbers::pi * swing_ / seconds_per_swing); }

std::optional<Message> Session::watch_mesher()
{
    const auto said = [&](const std::vector<Fault>& faults) {
        return Message(sentence(faults.front(), model(), tr()));
    };
    if (!solution_->is_sound()) return said(solution_->faults());
    if (drawing() == nullptr) return translatable("there is nothing to be meshed");
    constexpr std::size_t most_elements = 20'000;
    constexpr double longest = 5.0; // [s]
    const auto is_late = [start = Clock::now()] { return seconds_since(start) > longest; };
    const discretize::MeshedDrawing mesh(*drawing(), is_late, document().sizes());
    if (is_late() || (mesh.is_sound() && mesh.model().elements.size() > most_elements))
        return translatable("the mesh has too many elements to be watched; give a larger element size");
    if (!mesh.is_sound()) return said(mesh.faults());
    watch.begin(solution_, document().sizes());
    return std::nullopt;
}

void Session::toggle(const Part& part)
{
    if (is_selected(part)) {
        std::erase_if(selection_, [&](const Part& one) {
            const auto* const a = std::get_if<FacePlace>(&one);
            const auto* const b = std::get_if<FacePlace>(&part);
            return one == part || (a != nullptr && b != nullptr && face_of(*a) == face_of(*b));
        });
    } else {
        selection_.push_back(part);
    }
}

bool Session::is_selected(const Part& part) const
{
    const auto* const face = std::get_if<FacePlace>(&part);
    return std::ranges::any_of(selection_, [&](const Part& one) {
        const auto* const other = std::get_if<FacePlace>(&one);
        if (face != nullptr && other != nullptr) return face_of(*face) == face_of(*other);
        return one == part;
    });
}

std::optional<std::size_t> Session::face_of(const FacePlace& place) const
{
    return drawing() != nullptr ? drawing()->face_at(place.at) : std::nullopt;
}

std::optional<RegionId> Session::region_of(const Part& part) const
{
    const auto* const place = std::get_if<FacePlace>(&part);
    const auto face = place != nullptr ? face_of(*place) : std::nullopt;
    return face ? drawing()->faces()[*face].region : std::nullopt;
}

std::optional<RegionId> Session::selected_region() const
{
    if (selection_.size() != 1) return std::nullopt;
    return region_of(selection_.front());
}

std::vector<RegionId> Session::selected_regions() const
{
    std::vector<RegionId> all;
    for (const Part& part : selection_) {
        const std::optional<RegionId> region = region_of(part);
        if (!region) return {};
        if (std::ranges::find(all, *region) == all.end()) all.push_back(*region);
    }
    return all;
}

PlateHighlight Session::highlight(const std::vector<Part>& parts) const
{
    PlateHighlight lit;
    for (const Part& part : parts) {
        if (const auto* const point = std::get_if<NodeId>(&part)) lit.points.push_back(*point);
        if (const auto* const curve = std::get_if<CurveId>(&part)) lit.curves.push_back(*curve);
        if (const auto* const place = std::get_if<FacePlace>(&part))
            if (const auto face = face_of(*place)) lit.faces.push_back(*face);
    }
    return lit;
}

std::optional<Gap> Session::gap() const
{
    const bool was_left = gap_ && left_gap_ && gap_->from == left_gap_->from && gap_->to == left_gap_->to;
    return was_left ? std::nullopt : gap_;
}

void Session::leave_gap() { left_gap_ = gap_; }

} // namespace plane
