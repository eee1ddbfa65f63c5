#include "femoop/io/results/results_json.h"

#include <string_view>

#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/result/components.h"
#include "femoop/result/envelope.h"

namespace femoop {

namespace {

using Layout = JsonWriter::Layout;

/// Sentences, where there are any: how far the numbers hold, or that the structure is nearly a mechanism.
void write_warnings(JsonWriter& json, const Results& results)
{
    if (results.warnings().empty()) return;
    json.key("warnings").begin_array(Layout::Block);
    for (const Fault& warning : results.warnings()) json.value(message(warning));
    json.end();
}

/// Writes the cases of one model; the lists that every node and member needs are made once.
class CaseWriter {
public:
    CaseWriter(JsonWriter& json, const Model& model, std::size_t n_stations)
        : json_(json),
          model_(model),
          n_stations_(n_stations),
          dofs_(dof_list(model.analysis)),
          forces_(section_force_components(model.analysis)),
          all_(member_components(model.analysis)),
          equilibrium_(equilibrium_dofs(model.analysis))
    {}

    void write(const CaseResult& result)
    {
        json_.key(result.name()).begin_object(Layout::Block);
        json_.key("nodes").begin_object(Layout::Block);
        for (std::size_t i = 0; i < model_.nodes.size(); ++i) write_node(result, NodeId(i));
        json_.end();
        json_.key("members").begin_object(Layout::Block);
        for (std::size_t i = 0; i < model_.members.size(); ++i) write_member(result, MemberId(i));
        json_.end();
        write_equilibrium(result.equilibrium());
        json_.end();
    }

private:
    void write_node(const CaseResult& result, NodeId id)
    {
        json_.key(model_[id].id).begin_object();
        const NodeVector u = result.displacement(id);
        json_.key("u").begin_object();
        for (const Dof dof : dofs_) json_.member(name(dof), u[index(dof)]);
        json_.end();
        if (result.is_supported(id)) {
            const NodeVector reaction = result.reaction(id);
            json_.key("reaction").begin_object();
            for (const Dof dof : dofs_) json_.member(force_name(dof), reaction[index(dof)]);
            json_.end();
        }
        json_.end();
    }

    void write_member(const CaseResult& result, MemberId id)
    {
        const Curve curve = result.curve(id);
        json_.key(model_[id].id).begin_object(Layout::Block);
        write_end("start", curve, 0.0, Side::After);
        write_end("end", curve, curve.length(), Side::Before);
        json_.key("stations").begin_array(Layout::Block);
        for (const Station& station : curve.stations(n_stations_)) write_station(station);
        json_.end();
        json_.key("extremes").begin_object(Layout::Block);
        for (const MemberComponent component : all_) write_extremes(component, curve.extremes(component));
        json_.end().end();
    }

    void write_end(std::string_view key, const Curve& curve, double x, Side side)
    {
        json_.key(key).begin_object();
        for (const MemberComponent component : forces_)
            json_.member(name(component, model_.analysis), curve.value(component, x, side));
        json_.end();
    }

    void write_station(const Station& station)
    {
        json_.begin_object().member("x", station.x);
        for (const MemberComponent component : all_)
            json_.member(name(component, model_.analysis), value(station, component));
        json_.end();
    }

    void write_extremes(MemberComponent component, const Extremes& extremes)
    {
        json_.key(name(component, model_.analysis)).begin_object();
        json_.key("max").begin_object().member("x", extremes.max.x).member("value", extremes.max.value).end();
        json_.key("min").begin_object().member("x", extremes.min.x).member("value", extremes.min.value).end();
        json_.end();
    }

    void write_equilibrium(const Equilibrium& equilibrium)
    {
        json_.key("equilibrium").begin_object().member("residual", equilibrium.residual);
        write_sum("sum_loads", equilibrium.sum_loads);
        write_sum("sum_reactions", equilibrium.sum_reactions);
        json_.end();
    }

    void write_sum(std::string_view key, const NodeVector& sum)
    {
        json_.key(key).begin_array();
        for (const Dof dof : equilibrium_) json_.value(sum[index(dof)]);
        json_.end();
    }

    JsonWriter& json_;
    const Model& model_;
    std::size_t n_stations_;
    std::vector<Dof> dofs_;
    std::vector<MemberComponent> forces_, all_;
    std::vector<Dof> equilibrium_;
};

/// Writes the envelope of one model.
class EnvelopeWriter {
public:
    EnvelopeWriter(JsonWriter& json, const Model& model, const Results& results, const std::vector<CaseId>& cases)
        : json_(json),
          model_(model),
          results_(results),
          envelope_(results, cases),
          dofs_(dof_list(model.analysis)),
          all_(member_components(model.analysis))
    {}

    void write(std::size_t n_stations)
    {
        json_.key("envelope").begin_object(Layout::Block);
        json_.key("cases").begin_array();
        for (const CaseId id : envelope_.cases()) json_.value(model_.case_name(id));
        json_.end();
        json_.key("nodes").begin_object(Layout::Block);
        for (std::size_t i = 0; i < model_.nodes.size(); ++i) write_node(NodeId(i));
        json_.end();
        json_.key("members").begin_object(Layout::Block);
        for (std::size_t i = 0; i < model_.members.size(); ++i) write_member(MemberId(i), n_stations);
        json_.end().end();
    }

private:
    void write_node(NodeId id)
    {
        json_.key(model_[id].id).begin_object(Layout::Block);
        json_.key("u").begin_object(Layout::Block);
        for (const Dof dof : dofs_) write_range(name(dof), envelope_.displacement(id, dof));
        json_.end();
        if (results_[envelope_.cases().front()].is_supported(id)) {
            json_.key("reaction").begin_object(Layout::Block);
            for (const Dof dof : dofs_) write_range(force_name(dof), envelope_.reaction(id, dof));
            json_.end();
        }
        json_.end();
    }

    void write_member(MemberId id, std::size_t n_stations)
    {
        json_.key(model_[id].id).begin_object(Layout::Block);
        json_.key("extremes").begin_object(Layout::Block);
        for (const MemberComponent component : all_) {
            const GoverningExtremes extremes = envelope_.extremes(id, component);
            json_.key(name(component, model_.analysis)).begin_object();
            write_extreme("max", extremes.max);
            write_extreme("min", extremes.min);
            json_.end();
        }
        json_.end();
        json_.key("stations").begin_array(Layout::Block);
        for (const EnvelopeStation& station : envelope_.stations(id, all_, n_stations)) write_station(station);
        json_.end().end();
    }

    void write_station(const EnvelopeStation& station)
    {
        json_.begin_object().member("x", station.x);
        for (std::size_t i = 0; i < all_.size(); ++i) write_range(name(all_[i], model_.analysis), station.ranges[i]);
        json_.end();
    }

    void write_range(std::string_view key, const GoverningRange& range)
    {
        json_.key(key).begin_object();
        json_.key("max").begin_object().member("value", range.max.value);
        json_.member("case", model_.case_name(range.max.load_case)).end();
        json_.key("min").begin_object().member("value", range.min.value);
        json_.member("case", model_.case_name(range.min.load_case)).end();
        json_.end();
    }

    void write_extreme(std::string_view key, const GoverningExtreme& extreme)
    {
        json_.key(key).begin_object().member("x", extreme.x).member("value", extreme.value);
        json_.member("case", model_.case_name(extreme.load_case)).end();
    }

    JsonWriter& json_;
    const Model& model_;
    const Results& results_;
    Envelope envelope_;
    std::vector<Dof> dofs_;
    std::vector<MemberComponent> all_;
};

void write_vector(JsonWriter& json, std::string_view key, const Eigen::VectorXd& vector)
{
    json.key(key).begin_array();
    for (const double value : vector) json.value(value);
    json.end();
}

} // namespace

std::string results_json(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                         std::size_t n_stations)
{
    JsonWriter json;
    begin_output(json, model.units);
    write_warnings(json, results);
    json.key("cases").begin_object(Layout::Block);
    CaseWriter writer(json, model, n_stations);
    for (const CaseId id : cases) writer.write(results[id]);
    json.end().end();
    return json.take();
}

std::string envelope_json(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                          std::size_t n_stations)
{
    JsonWriter json;
    begin_output(json, model.units);
    write_warnings(json, results);
    EnvelopeWriter(json, model, results, cases).write(n_stations);
    json.end();
    return json.take();
}

std::string trace_json(const MemberTrace& trace, const Units& units)
{
    JsonWriter json;
    begin_output(json, units);
    json.key("trace").begin_object(Layout::Block).member("member", trace.member).member("length", trace.length);
    json.key("dofs").begin_array();
    for (const std::string& dof : trace.dofs) json.value(dof);
    json.end();
    json.key("own_dofs").begin_array();
    for (const std::string& dof : trace.own_dofs) json.value(dof);
    json.end();
    if (trace.constraint != Constraint::None)
        json.member("constraint", trace.constraint == Constraint::Rigid ? "rigid" : "inextensible");
    json.key("equations").begin_array();
    for (const int equation : trace.equations) json.value(equation);
    json.end();
    write_rows(json.key("local_stiffness"), trace.local_stiffness, Layout::Block);
    write_rows(json.key("transformation"), trace.transformation, Layout::Block);
    write_rows(json.key("global_stiffness"), trace.global_stiffness, Layout::Block);
    json.key("fixed_end").begin_object(Layout::Block);
    for (const MemberTrace::FixedEnd& forces : trace.fixed_end) {
        json.key(forces.load_case).begin_object();
        write_vector(json, "local", forces.local);
        write_vector(json, "global", forces.global);
        json.end();
    }
    json.end().end().end();
    return json.take();
}

} // namespace femoop
