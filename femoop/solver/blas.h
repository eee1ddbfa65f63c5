#pragma once

#include <string>

namespace femoop {

/// The BLAS that dense blocks go through, for whoever quotes a speed.
struct Blas {
    std::string
        name; ///< "OpenBLAS 0.3.21 ...", "BLAS of unknown make", or "none" where the library is built without CHOLMOD
    int threads = 1;
};
Blas blas();

} // namespace femoop
