#include "apps/cli/mohr.h"

#include <string>

#include "apps/cli/argument.h"
#include "apps/cli/mohr_cases.h"
#include "apps/cli/mohr_results.h"

namespace cli {

namespace {

class Mohr : public Subcommand {
public:
    std::string_view name() const override { return "mohr"; }
    HelpText help(const ui::Catalogue& tr) const override;
    void declare(OptionParser& options, const ui::Catalogue& tr) override;
    ExitStatus run(Console& console) override;

private:
    MohrWords words(const ui::Catalogue& tr) const;
    bool has_state() const { return !(stress_.empty() && strain_.empty() && rosette_.empty() && inertia_.empty()); }

    std::string stress_, strain_, rosette_, inertia_, E_, nu_, angle_, normal_, cases_, criterion_, strength_;
    bool is_plane_strain_ = false, is_json_ = false;
};

HelpText Mohr::help(const ui::Catalogue& tr) const
{
    return {
        tr("print Mohr's circle of a stress, a strain, a rosette or second moments of area"),
        tr("Of a plane state: centre and radius of the circle, principal values and directions, "
           "the pole, largest shear in the plane and in space, and the components in axes turned by --angle. In space: "
           "principal values and directions, invariants and what acts on the plane of --normal. Tension is positive; "
           "the circle has shear up where it turns the element clockwise, so face x is the point (SX, -TXY) and the "
           "pole is (SX, TXY); a strain's circle has GXY/2; of second moments the shear's axis points down and counts "
           "-IXY: face x is (IX, -IXY), the pole (IX, IXY). Numbers are bare or have a unit: \"120 MPa,80 MPa,0\"."),
        {{"cremona mohr --stress 50,-10,40 --angle 30", tr("A plane stress, also in axes turned by 30 degrees.")},
         {"cremona mohr --stress -19,4.6,-8.3,-4.7,11.8,6.45 --normal 1,1,1",
          tr("A stress in space, and what acts on an oblique plane.")},
         {"cremona mohr --rosette 0,60,120:60e-6,135e-6,264e-6 --E \"200 GPa\" --nu 0.3",
          tr("Strains and stresses from three gauges.")},
         {"cremona mohr --stress \"120 MPa,-40 MPa,60 MPa\" --criterion von_mises --strength \"fy=250 MPa\"",
          tr("The safety factor of a plane stress.")},
         {"cremona mohr --cases tests/states/published.json", tr("Every published state, compared.")}}};
}

void Mohr::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_option("--stress", stress_, tr("SX,SY,TXY of a plane stress, or SX,SY,SZ,TXY,TYZ,TZX in space"))
        .option_text("LIST");
    options
        .add_option("--strain", strain_, tr("EX,EY,GXY of a plane strain (EZ is 0), or EX,EY,EZ,GXY,GYZ,GZX in space"))
        .option_text("LIST");
    options
        .add_option("--rosette", rosette_,
                    tr("A1,A2,A3:R1,R2,R3: directions of three gauges in degrees, and their readings"))
        .option_text("LIST");
    options.add_option("--inertia", inertia_, tr("IX,IY,IXY, second moments of area")).option_text("LIST");
    options
        .add_option("--angle", angle_, tr("also the components in axes turned by so many degrees, counter-clockwise"))
        .option_text("DEG");
    options.add_option("--normal", normal_, tr("NX,NY,NZ: also what acts on the plane that is square to this vector"))
        .option_text("LIST");
    options.add_option("--E", E_, tr("Young's modulus: stresses follow from strains")).option_text("E");
    options
        .add_option("--nu", nu_,
                    tr("Poisson's ratio; of a plane strain it frees the surface: EZ = -NU (EX + EY)/(1 - NU)"))
        .option_text("NU");
    options.add_flag("--plane-strain", is_plane_strain_, tr("SZ of a plane stress is NU (SX + SY) instead of 0"));
    options
        .add_option("--criterion", criterion_,
                    tr("also the safety factor and the planes that fail: "
                       "tresca, von_mises, rankine, mohr_coulomb, drucker_prager or hoek_brown"))
        .option_text("NAME");
    options
        .add_option(
            "--strength", strength_,
            tr("what the criterion reads: fy=...; ft=...,fc=...; c=...,phi=...; sci=...,m=...,s=...; phi in degrees"))
        .option_text("LIST");
    options
        .add_option("--cases", cases_, tr("run every state of a file and compare what it expects; - is standard input"))
        .option_text("FILE");
    options.add_flag("--json", is_json_, tr("print JSON instead of tables"));
}

std::vector<std::string> list_of(const std::string& text)
{
    return text.empty() ? std::vector<std::string>{} : comma_list(text);
}

MohrWords Mohr::words(const ui::Catalogue& tr) const
{
    MohrWords words;
    words.stress = list_of(stress_);
    words.strain = list_of(strain_);
    words.inertia = list_of(inertia_);
    words.normal = list_of(normal_);
    words.E = E_;
    words.nu = nu_;
    words.angle = angle_;
    words.criterion = criterion_;
    words.strength = list_of(strength_);
    words.is_plane_strain = is_plane_strain_;
    if (rosette_.empty()) return words;
    const auto colon = rosette_.find(':');
    if (colon == std::string::npos)
        throw UsageError(tr("--rosette: found {found}; wanted A1,A2,A3:R1,R2,R3, directions, a colon, readings",
                            {{"found", "\"" + rosette_ + "\""}}));
    words.rosette_angles = comma_list(std::string_view(rosette_).substr(0, colon));
    words.rosette_readings = comma_list(std::string_view(rosette_).substr(colon + 1));
    return words;
}

ExitStatus Mohr::run(Console& console)
{
    const ui::Catalogue& tr = console.tr();
    if (!cases_.empty()) {
        if (has_state()) throw UsageError(tr("--cases: a state is given too; take one of them away"));
        return run_mohr_cases(cases_, is_json_, console);
    }
    const MohrProblem problem = mohr_problem(words(tr), tr);
    const auto results = mohr_results(problem);
    console.print(is_json_ ? mohr_json(results, problem) : mohr_table(results, problem, tr));
    return ExitStatus::Done;
}

} // namespace

std::unique_ptr<Subcommand> mohr_command() { return std::make_unique<Mohr>(); }

} // namespace cli
