#pragma once

#include <cholmod.h>

namespace femoop {

/// CHOLMOD's settings and workspace, which every call needs.
struct CholmodSession {
    CholmodSession()
    {
        cholmod_start(&common);
        common.print = 0; // outcomes are read from `status`, nothing is written
    }
    ~CholmodSession() { cholmod_finish(&common); }
    CholmodSession(const CholmodSession&) = delete;
    CholmodSession& operator=(const CholmodSession&) = delete;

    cholmod_common common;
};

} // namespace femoop
