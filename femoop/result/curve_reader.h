#pragma once

#include <memory>

#include "femoop/result/curve.h"
#include "femoop/result/results.h"

namespace femoop {

namespace detail {
class AnyReader;
}

/// Reads the curves of many members of one case, one after the other, without allocating for each.
/// Two readers of one case may work at the same time, each in a thread of its own.
class CurveReader {
public:
    explicit CurveReader(const CaseResult& result);
    ~CurveReader();
    CurveReader(const CurveReader&) = delete;
    CurveReader& operator=(const CurveReader&) = delete;

    const Curve& read(MemberId member); ///< valid until the next read

private:
    std::shared_ptr<const detail::Solution> solution_;
    std::unique_ptr<detail::AnyReader> reader_;
    Curve curve_;
};

} // namespace femoop
