#include "apps/cli/render.h"

#include <algorithm>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "apps/cli/argument.h"
#include "apps/cli/asked_units.h"
#include "apps/cli/model_input.h"
#include "apps/cli/moving_picture.h"
#include "apps/cli/picture.h"
#include "apps/cli/plane_render.h"
#include "apps/cli/truss_picture.h"
#include "apps/frame/document/companion/companion_file.h"
#include "apps/frame/view/kept_view.h"
#include "femoop/result/structure_words.h"
#include "ui/files/view_file.h"
#include "ui/text/language_manner.h"

namespace cli {

namespace {

class Render : public Subcommand {
public:
    std::string_view name() const override { return "render"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(OptionParser& options, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    void require_sensible_reference(const femoop::Model& model, const ui::Catalogue& tr) const;
    PictureOrder order(const ui::Catalogue& tr) const;
    void choose_case(drawing::DrawOptions& view, const femoop::Model& model, const ui::Catalogue& tr) const;
    void look_at_view(PictureOrder& order, const frame::Companion& companion, const femoop::Model& model,
                      const ui::Catalogue& tr) const;
    frame::CompanionReading companion(const Console& console, const femoop::Model& model) const;
    ExitStatus draw_plane(femoop::plane::PlaneReading& reading, Console& console) const;
    ExitStatus draw_structure(const femoop::Model& model, PictureOrder picture, Console& console) const;

    std::string file_, out_, theme_ = "light", size_ = "1280x800", scale_ = "1";
    std::optional<std::string> show_, case_, view_, magnification_, mechanism_, other_, with_;
    AskedUnits units_;
    MovingPicture moving_;
    TrussPicture truss_;
    PlaneRender plane_;
};

std::string show_list(const ui::Catalogue& tr)
{
    std::string text;
    for (const drawing::ShowWord& word : drawing::show_text())
        text += "\n" + std::string(word.word) + ": " + tr(word.meaning);
    return text;
}

std::string plate_show_list(const ui::Catalogue& tr)
{
    std::string text = "\n" + tr("of a plane model (default geometry,regions,loads,supports,labels):");
    for (const ::plane::PlateShowWord& word : ::plane::plate_show_words())
        text += "\n" + std::string(word.word) + ": " + tr(word.meaning);
    return text + "\n" +
           tr("bands:C, contour:C: colours or lines of a component: sx sy sz txy s1 s2 tmax mises tresca ex ey ez gxy ux "
              "uy");
}

HelpText Render::help(const ui::Catalogue& tr) const
{
    return {
        tr("draw a model and its results to PNG, SVG or PDF"),
        tr("Draws members, nodes and supports as textbooks do, and what --show asks for. "
           "No display is needed. A structure that can move is drawn moving, and the status is 3; a plane model is, where "
           "its results or --mechanism are asked for."),
        {{"cremona render examples/portal.json -o portal.svg", tr("The structure, its loads and its reactions.")},
         {"cremona render examples/portal.json -o moments.png --show loads,M,labels --size 1920x1080",
          tr("Bending moments on the tension side, for a slide.")},
         {"cremona render examples/portal.json -o sag.pdf --show deformed,labels --magnify 100 --theme print",
          tr("The deformed shape, displacements a hundred times as large, in black for paper.")},
         {"cremona render examples/portal.json -o wind.svg --show M,labels --case W --with G",
          tr("The moments of one load case before those of another.")},
         {"cremona render examples/bridge.json -o truck.svg --train HS20",
          tr("A truck where it bends the bridge most, and the bridge under it.")},
         {"cremona render examples/pratt_truss.json -o cremona.svg --cremona",
          tr("A truss beside its Cremona diagram.")}}};
}

void Render::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("FILE", file_, tr("the model file; - is standard input")).option_text(" ");
    options
        .add_option("-o,--output", out_, tr("the picture to write; its extension chooses the kind: .png, .svg or .pdf"))
        .option_text("OUT");
    options
        .add_option("--show", show_,
                    tr("what is drawn, separated by commas (default loads,reactions,labels):") + show_list(tr) +
                        plate_show_list(tr))
        .option_text("LIST");
    options
        .add_option("--case", case_,
                    tr("the load case or combination that is drawn (default the first), or envelope: "
                       "the largest and smallest of all (of members)"))
        .option_text("ID|envelope");
    options
        .add_option("--view", view_,
                    tr("a view that the frame app keeps beside the model: what it shows, of which case, and how large"))
        .option_text("NAME");
    options.add_option("--size", size_, tr("width and height in pixels (default 1280x800)")).option_text("WxH");
    options
        .add_option("--scale", scale_,
                    tr("pixels per pixel of --size in a PNG: 2 draws it twice as sharp and twice as large (default 1)"))
        .option_text("K");
    options
        .add_option("--magnify", magnification_,
                    tr("draw displacements K times as large (default: a round number that shows them well)"))
        .option_text("K");
    options.add_option("--theme", theme_, tr("light (default), dark, print or projector (large type, thick lines)"))
        .option_text("NAME");
    units_.declare(options, tr);
    options.add_option("--mechanism", mechanism_, tr("which motion is drawn of a structure that can move (default 1)"))
        .option_text("N");
    options
        .add_option(
            "--compare", other_,
            tr("another model file, whose results stand behind, faint, to the same scale, matched by the names of "
               "the cases"))
        .option_text("OTHER");
    options
        .add_option("--with", with_,
                    tr("the load case or combination that is drawn behind: of the file of --compare, else of FILE"))
        .option_text("ID");
    moving_.declare(options, tr);
    truss_.declare(options, tr);
    plane_.declare(options, tr);
}

drawing::ShowSet shown(const std::string& list, const ui::Catalogue& tr)
{
    drawing::ShowSet set;
    for (const std::string& word : comma_list(list)) {
        try {
            set = set | drawing::parse_show(word);
        } catch (const drawing::ShowError&) {
            std::vector<std::string> words;
            for (const drawing::ShowWord& known : drawing::show_text()) words.emplace_back(known.word);
            throw unknown_choice("--show", word, words, tr);
        }
    }
    return set;
}

PictureOrder Render::order(const ui::Catalogue& tr) const
{
    if (out_.empty()) throw UsageError(tr("no output is given; add -o OUT.png, .svg or .pdf"));
    PictureOrder order{.file = picture_file(out_, size_, scale_, tr), .view = draw_options(tr)};
    if (mechanism_)
        order.mechanism = static_cast<std::size_t>(whole_number("--mechanism", *mechanism_, {1, 1000}, tr) - 1);
    order.view.theme = theme_named(theme_, tr);
    if (show_) order.view.show = shown(*show_, tr);
    order.view.unit_choices = units_.choices(tr);
    if (magnification_) order.view.deformation_scale = positive_number("--magnify", *magnification_, tr);
    return order;
}

// What stands beside the model in the picture; what is wrong with it is told and left out.
frame::CompanionReading Render::companion(const Console& console, const femoop::Model& model) const
{
    if (file_ == "-") return {};
    frame::CompanionReading reading = frame::read_companion_of(file_, model);
    console.report(ui::view_path(file_).string(), reading.faults);
    return reading;
}

// What a kind of structure does not have is not drawn.
void tell_of_absent(const std::string& list, femoop::AnalysisKind kind, const Console& console)
{
    const ui::Catalogue& tr = console.tr();
    for (const std::string& word : comma_list(list))
        if (drawing::parse_show(word) == drawing::ShowSet{drawing::Show::Thrust} &&
            kind != femoop::AnalysisKind::Frame2d)
            console.message(
                tr("--show {word}: a {kind} has no line of thrust, and none is drawn; plane frames have one",
                   {{"word", word}, {"kind", kind_text(kind, tr)}}));
}

// A case that bears the name of the keyword is still reached.
void Render::choose_case(drawing::DrawOptions& view, const femoop::Model& model, const ui::Catalogue& tr) const
{
    view.is_envelope = *case_ == "envelope" && !model.find_case("envelope");
    if (!view.is_envelope) view.load_case = find_case(model, *case_, tr);
    else if (model.n_cases() == 0)
        throw UsageError(tr("--case: an envelope needs at least one load case, and the model has none"));
}

// What other options say stands above what the view says.
void Render::look_at_view(PictureOrder& order, const frame::Companion& companion, const femoop::Model& model,
                          const ui::Catalogue& tr) const
{
    if (companion.views.empty()) throw UsageError(tr("--view: no views are kept beside the model"));
    const auto kept = std::ranges::find(companion.views, *view_, &frame::NamedView::name);
    if (kept == companion.views.end()) {
        std::vector<std::string> names;
        for (const frame::NamedView& known : companion.views) names.push_back(known.name);
        throw unknown_choice("--view", *view_, names, tr);
    }
    const drawing::DrawOptions asked_for = order.view;
    frame::look_as(order.view, *kept, model);
    order.region = kept->region;
    if (show_) order.view.show = asked_for.show;
    if (magnification_) order.view.deformation_scale = asked_for.deformation_scale;
}

ExitStatus Render::draw_plane(femoop::plane::PlaneReading& reading, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    if (view_ || other_ || with_ || moving_.is_of_members() || truss_.is_asked())
        throw UsageError(tr(
            "a plane model is drawn with --show, --case, --at, --cut, --read, --range, --step, --describe, --magnify, --mechanism, --unit, --theme, "
            "--size and --scale; what else was asked for is of a structure of members"));
    const bool has_file = !out_.empty() || !plane_.is_described();
    if (has_file && out_.empty()) throw UsageError(tr("no output is given; add -o OUT.png, .svg or .pdf"));
    PlaneRender::Order order{.file = picture_file(has_file ? out_ : "words.png", size_, scale_, tr),
                             .has_file = has_file,
                             .model_file = file_ == "-" ? std::nullopt : std::optional(file_),
                             .show = show_,
                             .load_case = case_};
    order.look.theme = theme_named(theme_, tr);
    order.look.tr = tr;
    order.look.numbers.mark = ui::decimal_mark(tr.language());
    order.look.unit_choices = units_.choices(tr);
    if (magnification_) order.look.deformation_scale = positive_number("--magnify", *magnification_, tr);
    if (mechanism_)
        order.mechanism = static_cast<std::size_t>(whole_number("--mechanism", *mechanism_, {1, 1000}, tr) - 1);
    return plane_.draw(reading, display_name(file_, tr), order, console);
}

ExitStatus Render::draw_structure(const femoop::Model& model, PictureOrder picture, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    const frame::CompanionReading beside = companion(console, model);
    picture.dimensions = beside.companion.dimensions;
    if (view_) look_at_view(picture, beside.companion, model, tr);
    if (show_) tell_of_absent(*show_, model.analysis, console);
    if (case_) choose_case(picture.view, model, tr);
    if (case_ == "envelope") tell_of_case_named_as_keyword(case_, model, console);
    if (truss_.is_asked()) return truss_.draw(model, display_name(file_, tr), picture, show_.has_value(), console);
    if (moving_.is_asked()) return moving_.draw(model, display_name(file_, tr), picture, show_.has_value(), console);
    return draw_picture(model, display_name(file_, tr), picture, console);
}

void Render::require_sensible_reference(const femoop::Model& model, const ui::Catalogue& tr) const
{
    if (!other_ && !with_) return;
    const std::string_view option = other_ ? "--compare" : "--with";
    if (truss_.is_asked()) throw ask_for_different_things(option, "--truss", tr);
    if (moving_.is_asked()) throw ask_for_different_things(option, "--influence, --train", tr);
    if (case_ == "envelope" && !model.find_case("envelope"))
        throw ask_for_different_things(option, "--case envelope", tr);
    if (file_ == "-" && other_ == "-") throw UsageError(tr("standard input is one file; name the other one"));
}

ExitStatus Render::run(Console& console)
{
    const ui::Catalogue& tr = console.tr();
    if (file_.empty()) throw no_file("render", tr);
    femoop::AnyReading any = examine_any(file_, tr);
    if (auto* reading = std::get_if<femoop::plane::PlaneReading>(&any)) return draw_plane(*reading, console);
    plane_.require_none(tr);
    moving_.require_sensible(tr);
    truss_.require_sensible(tr);
    if (truss_.is_asked() && moving_.is_asked()) throw ask_for_different_things("--truss", "--influence, --train", tr);
    const auto& reading = std::get<femoop::ModelReading>(any);
    require_sensible_reference(reading.model, tr);
    PictureOrder picture = order(tr);
    if (other_ || with_) picture.reference = AskedReference{other_, with_, "--with"};
    console.report(display_name(file_, tr), reading.faults);
    if (!reading.is_sound()) return ExitStatus::BadInput;
    return draw_structure(reading.model, picture, console);
}

} // namespace

std::unique_ptr<Subcommand> render_command() { return std::make_unique<Render>(); }

} // namespace cli
