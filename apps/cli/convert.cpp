#include "apps/cli/convert.h"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/asked_bend.h"
#include "apps/cli/design_actions.h"
#include "apps/cli/model_input.h"
#include "apps/cli/output_file.h"
#include "apps/cli/picture.h"
#include "apps/cli/plane_input.h"
#include "apps/cli/plane_render.h"
#include "apps/cli/solid_file.h"
#include "apps/plane/outline/outline.h"
#include "femoop/io/any_model.h"
#include "femoop/io/plane/plane_output.h"
#include "femoop/io/results/results_csv.h"
#include "femoop/model/quantity/in_units.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "femoop/plane/model/plane_in_units.h"
#include "ui/text/language_manner.h"

namespace cli {

namespace {

class Convert : public Subcommand {
public:
    std::string_view name() const override { return "convert"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(OptionParser& options, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    ExitStatus to_json(const femoop::Model& model, Console& console) const;
    ExitStatus plane(femoop::plane::PlaneReading& reading, const std::string& kind, Console& console) const;
    ExitStatus to_csv(const femoop::Model& model, Console& console) const;
    ExitStatus to_csv(femoop::plane::PlaneReading& reading, Console& console) const;
    ExitStatus solids(Console& console) const;
    ExitStatus outline(Console& console) const;
    void deliver(const std::string& text, Console& console) const;

    std::string in_, out_;
    std::optional<std::string> units_;
    std::optional<std::string> combinations_;
    std::optional<std::string> actions_;
    AskedBend bend_;
};

HelpText Convert::help(const ui::Catalogue& tr) const
{
    return {
        tr("write a model in another form, chosen by the extension of OUT"),
        tr("From .json to .json the file is tidied (one node, member and load a line, keys in a fixed order; "
           "quantities stay as they were typed), and with --units its bare numbers are counted in other base units. "
           "To .csv the model is solved and every result is written in one long table, a value a row: case, "
           "part, id, place, component, value, unit. To .svg, .pdf or .png it is drawn; render has more to choose from.") +
            "\n\n" +
            tr("The curves of a drawing of another program, .dxf or .svg, become the drawing of a plane model in .json: "
               "lines, arcs, circles, ellipses and splines as such. What is left out is told.") +
            "\n\n" +
            tr("Solids go from .eul, .obj or .off to any of these; to .eul as a script "
               "of Euler operators that makes them, whose number of lines is the least that the theory asks for."),
        {{"cremona convert examples/portal.json portal_mm.json --units mm,N",
          tr("The same structure in millimetres and newtons.")},
         {"cremona convert examples/portal.json portal.csv", tr("Every result, for a spreadsheet.")},
         {"cremona convert examples/portal.json out.json --combinations EN1990 --actions G=permanent,W=wind",
          tr("The same structure with the combinations of a code.")},
         {"cremona convert examples/portal.json arch.json --bend members=BC,curve=parabola,rise=1.5,parts=16",
          tr("The same structure with a parabola of 16 straight parts for its beam.")},
         {"cremona convert examples/bracket.dxf bracket.json", tr("The outline of a plate that was drawn elsewhere.")},
         {"cremona convert examples/cube.eul cube.off", tr("The surface of a solid, for another program.")}}};
}

void Convert::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options
        .add_option(
            "IN", in_,
            tr("the model file (.json; - is standard input), an outline (.dxf, .svg), or a file of solids (.eul, "
               ".obj, .off)"))
        .option_text(" ");
    options
        .add_option(
            "OUT", out_,
            tr("the file to write: .json, .csv, .svg, .pdf or .png (- is standard output, as JSON); .eul, .obj or .off"))
        .option_text(" ");
    options
        .add_option("--units", units_,
                    tr("base units of the new file: a length (m mm cm km in ft) and a force (N kN MN lbf kip tf kgf)"))
        .option_text("LENGTH,FORCE");
    options
        .add_option(
            "--combinations", combinations_,
            tr("add the combinations of a code: NBR8681, EN1990 or ASCE7; --actions says what the load cases are"))
        .option_text("CODE");
    options
        .add_option(
            "--actions", actions_,
            tr("the action that each load case is, such as G=permanent,Q=offices,W=wind; a case without one is left "
               "out of the combinations"))
        .option_text("CASE=ACTION,...");
    bend_.declare(options, tr);
}

femoop::Units units_named(const std::string& text, const ui::Catalogue& tr)
{
    const std::vector<std::string> parts = comma_list(text);
    if (parts.size() != 2)
        throw UsageError(tr("--units: found {found}; wanted a length and a force, such as mm,N", {{"found", text}}));
    const auto length = femoop::find_length_unit(parts[0]);
    if (!length) throw unknown_choice("--units", parts[0], {"m", "mm", "cm", "km", "in", "ft"}, tr);
    const auto force = femoop::find_force_unit(parts[1]);
    if (!force) throw unknown_choice("--units", parts[1], {"N", "kN", "MN", "lbf", "kip", "tf", "kgf"}, tr);
    return {*length, *force};
}

/// Numbers may leave the range in which they are read when they are counted in other units; what is wrong with them is
/// told, by their new place.
template <class Reading> bool is_sound_in_new_units(const std::string& text, const Console& console)
{
    const femoop::AnyReading any = femoop::examine_any(text);
    const auto& reading = std::get<Reading>(any);
    if (reading.is_sound()) return true;
    console.message(console.tr()("--units: in these units the file could not be read again; choose others"));
    console.report("--units", reading.faults);
    return false;
}

void Convert::deliver(const std::string& text, Console& console) const
{
    if (out_ == "-") console.print(text);
    else write_file(out_, text, console.tr());
}

ExitStatus Convert::to_json(const femoop::Model& model, Console& console) const
{
    if (!units_) {
        deliver(femoop::write_model(model), console);
        return ExitStatus::Done;
    }
    const femoop::Units units = units_named(*units_, console.tr());
    if (!model.extra.empty() && !(units == model.units))
        throw UsageError(
            console.tr()("--units: the block \"{block}\" holds numbers that are not converted; take it out first",
                         {{"block", model.extra.front().key}}));
    const std::string text = femoop::write_model(units == model.units ? model : femoop::in_units(model, units));
    if (!is_sound_in_new_units<femoop::ModelReading>(text, console)) return ExitStatus::BadInput;
    deliver(text, console);
    return ExitStatus::Done;
}

/// A plane model is tidied, counted in other units, or drawn as `render` draws it by default.
ExitStatus Convert::plane(femoop::plane::PlaneReading& reading, const std::string& kind, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    if (combinations_ || bend_.is_asked())
        throw UsageError(tr("--combinations and --bend are for structures of members; this is a plane model"));
    if (units_ && kind != ".json") throw UsageError(tr("--units: only a .json file is written in other units"));
    if (kind == ".csv") return to_csv(reading, console);
    if (is_picture(out_)) {
        PlaneRender::Order order{.file = {.path = out_}, .model_file = in_ == "-" ? std::nullopt : std::optional(in_)};
        order.look.tr = tr;
        order.look.numbers.mark = ui::decimal_mark(tr.language());
        return PlaneRender().draw(reading, display_name(in_, tr), order, console);
    }
    drawing_of(reading);
    console.report(display_name(in_, tr), reading.faults);
    if (!reading.is_sound()) return ExitStatus::BadInput;
    const femoop::Units units = units_ ? units_named(*units_, tr) : reading.model.units;
    const bool is_same = units == reading.model.units;
    const std::string text = femoop::plane::write_plane_model(is_same ? reading.model
                                                                      : femoop::plane::in_units(reading.model, units));
    if (!is_same && !is_sound_in_new_units<femoop::plane::PlaneReading>(text, console)) return ExitStatus::BadInput;
    deliver(text, console);
    return ExitStatus::Done;
}

ExitStatus Convert::to_csv(const femoop::Model& model, Console& console) const
{
    const std::string file = display_name(in_, console.tr());
    const auto solved = solve_model(model, file, {}, console);
    if (const auto* status = std::get_if<ExitStatus>(&solved)) return *status;
    const femoop::Results& results = std::get<Solved>(solved).results;
    console.report(file, results.warnings());
    deliver(femoop::long_csv(model, results, all_cases(model), femoop::usual_n_stations), console);
    return ExitStatus::Done;
}

ExitStatus Convert::to_csv(femoop::plane::PlaneReading& reading, Console& console) const
{
    const std::string file = display_name(in_, console.tr());
    const PlaneInput input(reading);
    console.report(file, reading.faults);
    if (!reading.is_sound()) return ExitStatus::BadInput;
    try {
        const femoop::plane::PlaneResults results = femoop::plane::analyse(input.model(), {});
        console.report(file, results.warnings());
        deliver(femoop::plane::plane_long_csv(results), console);
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, file, console);
    }
    return ExitStatus::Done;
}

/// Solids are written as solids, and models as models.
void require_both_solids(const std::string& in, const std::string& out, const ui::Catalogue& tr)
{
    if (is_solid_file(in) && is_solid_file(out)) return;
    throw UsageError(tr("{in} and {out}: a file of solids (.eul, .obj, .off) is written as another one only",
                        {{"in", in}, {"out", out}}));
}

ExitStatus Convert::solids(Console& console) const
{
    require_both_solids(in_, out_, console.tr());
    if (units_) throw UsageError(console.tr()("--units: only a .json file is written in other units"));
    require_writable(out_, console.tr());
    save_solids(out_, load_solids(in_, console.tr()), console.tr());
    return ExitStatus::Done;
}

/// The curves of another program's drawing, in its own unit of length where the file says it, else in mm.
ExitStatus Convert::outline(Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    if (out_ != "-" && kind_of(out_) != ".json")
        throw UsageError(tr("{in}: an outline is written as a plane model, to .json", {{"in", in_}}));
    if (combinations_ || bend_.is_asked())
        throw UsageError(tr("{in}: with an outline goes --units alone", {{"in", in_}}));
    if (out_ != "-") require_writable(out_, tr);
    const outline::Outline found = load_outline(in_, tr);
    femoop::Units units{found.unit.value_or(femoop::LengthUnit::mm), femoop::ForceUnit::N};
    if (units_) units = units_named(*units_, tr);
    const femoop::plane::PlaneModel drawing = outline::drawing_of(found, units);
    if (drawing.curves.empty()) throw UsageError(tr("{in}: there is no curve in it", {{"in", in_}}));
    if (!found.unit)
        console.message(tr("{in}: the file has no unit; its numbers are taken as {unit}; --units chooses another",
                           {{"in", in_}, {"unit", std::string(femoop::name(units.length))}}));
    if (!found.left_out.empty())
        console.message(tr("{in}: left out: {what}", {{"in", in_}, {"what", outline::left_out_text(found)}}));
    deliver(femoop::plane::write_plane_model(drawing), console);
    return ExitStatus::Done;
}

ExitStatus Convert::run(Console& console)
{
    const ui::Catalogue& tr = console.tr();
    if (in_.empty() || out_.empty())
        throw UsageError(
            tr("two files are needed, IN and OUT; see {command}", {{"command", "cremona convert --help"}}));
    if (outline::is_outline_file(in_)) return outline(console);
    if (is_solid_file(in_) || is_solid_file(out_)) return solids(console);
    if (combinations_ && !actions_) throw needs_too("--combinations", "--actions", tr);
    if (actions_ && !combinations_) throw needs_too("--actions", "--combinations", tr);
    const std::string kind = out_ == "-" ? ".json" : kind_of(out_);
    if (kind != ".json" && kind != ".csv" && !is_picture(out_))
        throw UsageError(tr("{file}: cannot write the kind {kind}; choose from: .json, .csv, .svg, .pdf, .png",
                            {{"file", out_}, {"kind", "\"" + kind + "\""}}));
    if (out_ != "-") require_writable(out_, tr);
    femoop::AnyReading reading = examine_any(in_, tr);
    if (auto* plane = std::get_if<femoop::plane::PlaneReading>(&reading)) return this->plane(*plane, kind, console);
    auto& members = std::get<femoop::ModelReading>(reading);
    console.report(display_name(in_, tr), members.faults);
    if (!members.is_sound()) return ExitStatus::BadInput;
    femoop::Model* const model = &members.model;
    if (bend_.is_asked()) bend_.apply(*model, console);
    if (combinations_) add_design_combinations(*model, {*combinations_, *actions_}, console);
    if (units_ && kind != ".json") throw UsageError(tr("--units: only a .json file is written in other units"));
    if (kind == ".json") return to_json(*model, console);
    if (kind == ".csv") return to_csv(*model, console);
    return draw_picture(*model, display_name(in_, tr), {.file = {.path = out_}, .view = draw_options(tr)}, console);
}

} // namespace

std::unique_ptr<Subcommand> convert_command() { return std::make_unique<Convert>(); }

} // namespace cli
