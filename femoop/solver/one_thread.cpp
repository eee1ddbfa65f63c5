#include "femoop/solver/one_thread.h"

#include <mutex>

#include "femoop/solver/blas.h"
#include "femoop/solver/loaded_function.h"

namespace femoop {

namespace {

void give_blas(int threads)
{
    if (const auto set = loaded_function<void(int)>("openblas_set_num_threads")) set(threads);
}

/// The setting is the process's, so who has asked for it is known for the process.
struct BlasSetting {
    std::mutex mutex;
    int n_serial = 0;
    int threads_before = 1;
};
BlasSetting& blas_setting()
{
    static BlasSetting setting;
    return setting;
}

} // namespace

SerialLoops::SerialLoops() : levels_(1)
{
    const auto get = loaded_function<int()>("omp_get_max_active_levels");
    const auto set = loaded_function<void(int)>("omp_set_max_active_levels");
    if (get == nullptr || set == nullptr) return;
    levels_ = get();
    set(0);
}

SerialLoops::~SerialLoops()
{
    if (const auto set = loaded_function<void(int)>("omp_set_max_active_levels")) set(levels_);
}

SerialBlas::SerialBlas()
{
    BlasSetting& setting = blas_setting();
    const std::scoped_lock lock(setting.mutex);
    if (setting.n_serial++ > 0) return;
    setting.threads_before = blas().threads;
    give_blas(1);
}

SerialBlas::~SerialBlas()
{
    BlasSetting& setting = blas_setting();
    const std::scoped_lock lock(setting.mutex);
    if (--setting.n_serial == 0) give_blas(setting.threads_before);
}

} // namespace femoop
