#pragma once

#include "femoop/solver/multifrontal/dense_front.h"

// What is compiled for one kind of processor each; see dense_kernel.cpp.
namespace femoop::baseline {
std::int32_t eliminate(const DenseFront& front, double* workspace, const TileWorkers& workers);
void add_update(const DenseFront& front, const ChildUpdate& child, std::int32_t begin, std::int32_t end);
void solve_forward(const FrontColumns& L, double* x);
void solve_backward(const FrontColumns& L, double* x);
} // namespace femoop::baseline
namespace femoop::avx2 {
std::int32_t eliminate(const DenseFront& front, double* workspace, const TileWorkers& workers);
void add_update(const DenseFront& front, const ChildUpdate& child, std::int32_t begin, std::int32_t end);
void solve_forward(const FrontColumns& L, double* x);
void solve_backward(const FrontColumns& L, double* x);
} // namespace femoop::avx2
namespace femoop::avx512 {
std::int32_t eliminate(const DenseFront& front, double* workspace, const TileWorkers& workers);
void add_update(const DenseFront& front, const ChildUpdate& child, std::int32_t begin, std::int32_t end);
void solve_forward(const FrontColumns& L, double* x);
void solve_backward(const FrontColumns& L, double* x);
} // namespace femoop::avx512
