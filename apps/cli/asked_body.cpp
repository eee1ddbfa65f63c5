#include "apps/cli/asked_body.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <vector>

#include "apps/cli/argument.h"
#include "apps/cli/asked_effect.h"
#include "apps/cli/asked_units.h"
#include "femoop/io/free_body/free_body_text.h"
#include "femoop/io/json/model_json.h"
#include "femoop/model/quantity/six_digits.h"

namespace cli {

namespace {

using femoop::Model;
using namespace femoop::free_body;

/// What stands behind each key of "cut=BC@2,DE@50%,beside=A".
struct Words {
    std::vector<std::string> node, members, cut, beside;
};

UsageError not_understood(const std::string& text, const ui::Catalogue& tr)
{
    return UsageError(tr("--free-body: \"{found}\" names no body; write it like \"node=B\", \"members=AB,BC\" or "
                         "\"cut=BC@2,DE@50%,beside=A\"",
                         {{"found", femoop::printable(text)}}));
}

Words words_of(const std::string& text, const ui::Catalogue& tr)
{
    Words words;
    const std::array<KeyedList, 4> keys{
        {{"node=", &words.node}, {"members=", &words.members}, {"cut=", &words.cut}, {"beside=", &words.beside}}};
    if (!read_keyed_lists(text, keys)) throw not_understood(text, tr);
    return words;
}

femoop::NodeId node_named(const Model& model, const std::string& name, const ui::Catalogue& tr)
{
    if (const auto node = model.find_node(name)) return *node;
    throw unknown_choice("--free-body", name, ids_of(model.nodes), tr);
}

/// "BC@2", "BC@50%"
Cut cut_named(const Model& model, const std::string& text, const ui::Catalogue& tr)
{
    const std::size_t at = text.rfind('@');
    if (at == std::string::npos) throw not_understood(text, tr);
    const femoop::MemberId member = member_named("--free-body", text.substr(0, at), model, tr);
    const double length = femoop::geometry_of(model, model[member]).length;
    const double x = place_named("--free-body", text.substr(at + 1), length, model);
    if (x < 0.0 || x > length)
        throw UsageError(tr("--free-body: found the cut {found}; wanted a place from 0 to {length} along the member",
                            {{"found", text},
                             {"length", femoop::six_digits(length, tr) + " " +
                                            femoop::unit_text(femoop::dimension::length, model.units)}}));
    return {member, x};
}

} // namespace

void AskedBody::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options
        .add_option(
            "--free-body", what_,
            tr("print the forces on a part of the structure and its equations of equilibrium, instead of the results: "
               "node=N, members=M,.., or cut=M@X,..,beside=N for all that hangs together with a node where members are "
               "cut; of the first load case, or that of --case"))
        .option_text("WHAT");
    options
        .add_option(
            "--about", about_,
            tr("with --free-body: the point that moments are taken about (default: the first Ritter point of a cut "
               "through bars, or the first section, or node)"))
        .option_text("X,Y");
}

void AskedBody::require_sensible(const ui::Catalogue& tr) const
{
    if (about_ && !what_) throw needs_too("--about", "--free-body", tr);
}

void AskedBody::count_lengths_in(std::string_view unit)
{
    if (what_) what_ = with_unit(*what_, unit, "@");
    if (about_) about_ = with_unit(*about_, unit);
}

Body AskedBody::body(const Model& model, const ui::Catalogue& tr) const
{
    const Words words = words_of(*what_, tr);
    const femoop::Discretisation structure = discretise(model);
    const bool asks_for_node = words.node.size() == 1 && words.members.empty() && words.cut.empty();
    const bool asks_for_side = !words.beside.empty() && words.node.empty() && words.members.empty();
    if (asks_for_node && words.beside.empty()) return body_of(node_named(model, words.node.front(), tr));
    if (asks_for_side && !words.cut.empty()) {
        std::vector<Cut> cuts;
        for (const std::string& text : words.cut) cuts.push_back(cut_named(model, text, tr));
        std::vector<femoop::NodeId> beside;
        for (const std::string& name : words.beside) beside.push_back(node_named(model, name, tr));
        if (const auto across = members_across(structure, cuts); !across.empty())
            throw UsageError("--free-body: " + uncut_sentence(across, model, tr));
        return body_of(structure, cuts, beside);
    }
    if (words.members.empty() || !words.node.empty() || !words.cut.empty() || !words.beside.empty())
        throw not_understood(*what_, tr);
    return body_of(structure, members_named("--free-body", words.members, model, tr));
}

Eigen::Vector3d AskedBody::about(const Model& model, const FreeBody& body, const ui::Catalogue& tr) const
{
    if (!about_) return usual_moment_point(body, model);
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    const std::vector<double> place = lengths_named("--about", *about_, n_coordinates(model.analysis), model, tr);
    require_near("--about", *about_, place, model, tr);
    std::ranges::copy(place, point.begin());
    return point;
}

std::string AskedBody::output(const Model& model, const femoop::Results& results, femoop::CaseId load_case,
                              StepFormat format, const ui::Catalogue& tr) const
{
    const FreeBody lifted = lift_out(model, results, load_case, body(model, tr));
    const Eigen::Vector3d point = about(model, lifted, tr);
    if (format == StepFormat::Text) return free_body_text(lifted, model, point, tr);
    if (format == StepFormat::Latex) return free_body_latex(lifted, model, point, tr);
    femoop::JsonWriter json;
    begin_output(json, model.units);
    json.key("free_body").begin_object(femoop::JsonWriter::Layout::Block).member("case", model.case_name(load_case));
    write_free_body(json, lifted, model, point);
    json.end().end();
    return json.take();
}

} // namespace cli
