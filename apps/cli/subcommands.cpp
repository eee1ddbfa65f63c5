#include "apps/cli/subcommands.h"

#include "apps/cli/bench.h"
#include "apps/cli/check.h"
#include "apps/cli/compare.h"
#include "apps/cli/convert.h"
#include "apps/cli/cross.h"
#include "apps/cli/euler.h"
#include "apps/cli/influence.h"
#include "apps/cli/mesh.h"
#include "apps/cli/mohr.h"
#include "apps/cli/render.h"
#include "apps/cli/solve.h"
#include "apps/cli/train.h"
#include "apps/cli/truss.h"
#include "apps/cli/verify.h"

namespace cli {

std::vector<std::unique_ptr<Subcommand>> all_subcommands()
{
    std::vector<std::unique_ptr<Subcommand>> all;
    all.push_back(solve_command());
    all.push_back(verify_command());
    all.push_back(check_command());
    all.push_back(compare_command());
    all.push_back(render_command());
    all.push_back(convert_command());
    all.push_back(cross_command());
    all.push_back(influence_command());
    all.push_back(euler_command());
    all.push_back(train_command());
    all.push_back(truss_command());
    all.push_back(mesh_command());
    all.push_back(mohr_command());
    all.push_back(bench_command());
    return all;
}

} // namespace cli
