#include "apps/mohr/session/report.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/mohr/session/commands.h"
#include "apps/mohr/view/names.h"

namespace mohr {

namespace fm = femoop::mohr;

namespace {

constexpr double per_degree = 180.0 / std::numbers::pi;

/// Builds the tables, in one language and one unit.
class Teller {
public:
    explicit Teller(const Session& session)
        : tr_(session.tr()),
          look_(session.look),
          document_(session.document()),
          s_(session.solution()),
          names_(names_of(document_.subject))
    {}

    std::vector<tabular::Table> tables()
    {
        if (is_in_space(document_.subject)) add_directions();
        else add_circle();
        add_plane();
        if (s_.strength) add_failure();
        if (s_.space) add_space();
        if (s_.stress) add_stress();
        return std::move(tables_);
    }

private:
    struct Amount {
        double value;
        std::string unit;
    };
    static Amount amount(double value, const std::string& unit) { return {value, unit}; }
    Amount amount(double value) const { return {value, s_.unit}; }
    std::string degrees(std::optional<double> angle) const
    {
        return angle ? look_.number(*angle * per_degree) + "°" : tr_("undefined");
    }
    std::string vector(const Eigen::Vector3d& v) const
    {
        return "(" + look_.number(v[0]) + "; " + look_.number(v[1]) + "; " + look_.number(v[2]) + ")";
    }

    std::string pair(const fm::CirclePoint& point) const
    {
        return "(" + look_.number(point.normal) + "; " + look_.number(point.shear) + ")";
    }

    void begin(const std::string& heading)
    {
        tables_.emplace_back(std::vector<tabular::Column>{"", "", ""});
        tables_.back().title = heading;
    }
    void add(const std::string& name, const std::string& value)
    {
        tables_.back().add_row({name, tabular::written_cell(value), ""});
    }
    void add(const std::string& name, const Amount& amount)
    {
        const std::string text = with_unit(look_.number(amount.value), amount.unit);
        tables_.back().add_row({name, {amount.value, text}, amount.unit});
    }
    void add_angle(const std::string& name, const std::optional<double>& angle)
    {
        if (!angle) return add(name, degrees(angle));
        tables_.back().add_row({name, {*angle * per_degree, degrees(angle)}, "°"});
    }

    /// Of a strain both what the tensor has and what a gauge or a book means.
    void add_shear(const std::string& name, double value)
    {
        if (!fm::is_strain(s_.state.kind)) return add(name, amount(value));
        add(name + ", γ/2", amount(value));
        add(name + ", γ", amount(2.0 * value));
    }

    void add_circle()
    {
        begin(tr_("Circle"));
        add(tr_("centre"), amount(s_.circle.centre));
        add(tr_("radius"), amount(s_.circle.radius));
        add(names_.first, amount(s_.principal.first));
        add(names_.second, amount(s_.principal.second));
        add_angle("θp1", s_.principal.angle);
        add_angle("θs", s_.shear_angle);
        add(tr_("pole of planes"), pair(s_.pole_of_planes));
        add(tr_("pole of normals"), pair(s_.pole_of_normals));
        if (!fm::is_possible(s_.state)) add(tr_("no section has these"), tr_("a principal one is negative"));
    }

    void add_directions()
    {
        begin(tr_("Principal values"));
        const std::array<std::string, 3> values{names_.first, names_.second, names_.third};
        for (int i = 0; i < 3; ++i)
            add(values[static_cast<std::size_t>(i)], amount(s_.space_principal.values[static_cast<std::size_t>(i)]));
        for (int i = 0; i < 3; ++i)
            add(tr_("direction {n}", {{"n", std::to_string(i + 1)}}), vector(s_.space_principal.directions.col(i)));
    }

    void add_plane()
    {
        const bool is_space = is_in_space(document_.subject);
        if (is_space) {
            begin(tr_("On the plane"));
            add("n", vector(s_.on_plane.normal));
            add(tr_("traction"), vector(s_.on_plane.traction));
            add(names_.normal, amount(s_.on_plane.normal_component));
            add(names_.shear, amount(s_.on_plane.shear));
            return;
        }
        begin(tr_("In axes turned by {angle}°", {{"angle", look_.number(document_.angle)}}));
        const bool is_strain = fm::is_strain(s_.state.kind);
        const bool is_inertia = document_.subject == Subject::Inertia;
        add(names_.normal + "x′", amount(s_.turned.x));
        add(names_.normal + "y′", amount(s_.turned.y));
        add(std::string(is_strain    ? "γ"
                        : is_inertia ? "I"
                                     : "τ") +
                "x′y′",
            amount(fm::given_shear(s_.state.kind, s_.turned.xy)));
    }

    void add_space()
    {
        begin(tr_("In space"));
        if (!is_in_space(document_.subject)) {
            add(names_.normal + "z", amount(s_.space->z));
            add_shear(tr_("largest shear in the plane"), s_.circle.radius);
        }
        add_shear(tr_("largest shear in space"), s_.absolute_shear);
        add("I1", amount(s_.invariants.I1));
        add("I2", amount(s_.invariants.I2, unit_power(s_.unit, 2)));
        add("I3", amount(s_.invariants.I3, unit_power(s_.unit, 3)));
        add("J2", amount(s_.deviator.J2, unit_power(s_.unit, 2)));
        add("J3", amount(s_.deviator.J3, unit_power(s_.unit, 3)));
        add(tr_("octahedral normal"), amount(s_.deviator.mean));
        add_shear(tr_("octahedral shear"), s_.deviator.octahedral_shear);
        add_angle(tr_("Lode angle θ: cos 3θ = 3√3 J3 / (2 J2 √J2), 0° in axial tension"), s_.deviator.lode);
        for (std::size_t i = 0; i < 3; ++i)
            add(tr_("deviator, {n}", {{"n", std::to_string(i + 1)}}), amount(s_.deviator.values[i]));
        if (fm::is_stress(s_.state.kind)) add("von Mises", amount(s_.deviator.equivalent));
    }

    void add_stress()
    {
        begin(tr_("Stresses by E and ν"));
        add("σx", amount(s_.stress->x, s_.stress_unit));
        add("σy", amount(s_.stress->y, s_.stress_unit));
        add("τxy", amount(s_.stress->xy, s_.stress_unit));
        for (std::size_t i = 0; i < 3; ++i)
            add("σ" + std::to_string(i + 1), amount(s_.principal_stress->values[i], s_.stress_unit));
    }

    void add_failure()
    {
        for (const CriterionEntry& entry : criteria())
            if (entry.value == document_.criterion) begin(tr_(entry.label));
        if (!s_.safety->factor) return add(tr_("safety factor"), tr_("never fails this way"));
        const double k = *s_.safety->factor;
        add(tr_("safety factor"), Amount{k, ""});
        add("", k < 1.0 ? tr_("it has failed") : tr_("it holds"));
        const bool is_energy = document_.criterion == fm::Criterion::VonMises ||
                               document_.criterion == fm::Criterion::DruckerPrager;
        for (const Eigen::Vector3d& normal : s_.safety->planes)
            add(is_energy ? tr_("an octahedral plane") : tr_("failing plane"), plane_text(normal));
    }

    /// By its angle from x where it is square to the plane of the state.
    std::string plane_text(const Eigen::Vector3d& normal) const
    {
        const bool is_plane = !is_in_space(document_.subject) && std::abs(normal[2]) < 1e-9;
        return is_plane ? "θ = " + degrees(fm::as_direction(std::atan2(normal[1], normal[0]))) : vector(normal);
    }

    const ui::Catalogue& tr_;
    const Look& look_;
    const Document& document_;
    const Solution& s_;
    Names names_;
    std::vector<tabular::Table> tables_;
};

} // namespace

std::vector<tabular::Table> result_tables(const Session& session) { return Teller(session).tables(); }

std::string given_number(const Session& session, std::size_t place)
{
    const Document& document = session.document();
    std::string number = ui::with_minus_signs(printed_unit(document.state()[place]));
    if (session.look.format().mark == ui::DecimalMark::Comma) std::ranges::replace(number, '.', ',');
    return std::string(names(document.subject)[place]) + " = " +
           with_unit(number, std::string(bare_unit(document.subject, place)));
}

std::string description(const Session& session)
{
    const ui::Catalogue& tr = session.tr();
    const Document& document = session.document();
    std::string words, given;
    for (const SubjectEntry& entry : subjects())
        if (entry.value == document.subject) words += tr(entry.label) + ": ";
    if (document.subject == Subject::Section) given = document.section;
    for (std::size_t i = 0; i < document.state().size(); ++i)
        given += (given.empty() ? "" : ", ") + given_number(session, i);
    words += given + "\n";
    if (session.is_concealing()) return words + "\n" + tr("The results are shown when the exercise is done.") + "\n";
    for (const tabular::Table& group : result_tables(session)) {
        words += "\n" + group.title + "\n";
        for (const auto& [cells, kind] : group.rows)
            words += "  " + cells[0].shown + (cells[0].shown.empty() ? "" : ": ") + cells[1].shown + "\n";
    }
    for (const ui::Message& remark : remarks(session.document(), session.solution())) words += "\n" + tr(remark) + "\n";
    return words;
}

std::string status_text(const Session& session)
{
    const Solution& s = session.solution();
    const Names names = names_of(session.document().subject);
    const Look& look = session.look;
    if (is_in_space(session.document().subject)) {
        const auto& v = s.space_principal.values;
        return names.first + " = " + look.number(v[0]) + "   ·   " + names.second + " = " + look.number(v[1]) +
               "   ·   " + names.third + " = " + with_unit(look.number(v[2]), s.unit);
    }
    return names.first + " = " + look.number(s.principal.first) + "   ·   " + names.second + " = " +
           with_unit(look.number(s.principal.second), s.unit) + "   ·   R = " + look.number(s.circle.radius);
}

} // namespace mohr
