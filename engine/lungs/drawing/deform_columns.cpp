#include "engine/lungs/drawing/deform_columns.h"

#include "engine/core/expects.h"
#include "engine/geometry/deformation/moved_vertex.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

// One copy of each loop for each kind of processor; the right one is picked as the program starts.
// Sanitizers do not run that early.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)                                \
    && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CARINA_FOR_EACH_PROCESSOR                                                                  \
    __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define CARINA_FOR_EACH_PROCESSOR
#endif

namespace carina
{
namespace
{

constexpr std::size_t kVerticesAtOnce = 16384;

/// What every vertex of a mesh is moved by.
struct SingleField {
    ChestFrame<float> frame;
    ChestCoefficients<float> terms;
    Shares<float> metrePer;
};

// Each column is an argument of its own: only then does the compiler know that they do not overlap,
// and moves several vertices at a time.
template <bool kBothSides, bool kAll>
CARINA_FOR_EACH_PROCESSOR void
move(const SingleField& field, std::size_t begin, std::size_t end, const float* __restrict x,
     const float* __restrict y, const float* __restrict z, const float* __restrict nx,
     const float* __restrict ny, const float* __restrict nz, float* __restrict outX,
     float* __restrict outY, float* __restrict outZ, float* __restrict outNx,
     float* __restrict outNy, float* __restrict outNz)
{
    const SingleField f = field;
    for (std::size_t i = begin; i < end; ++i) {
        const MovedVertex<float> moved = movedVertex<kBothSides, kAll>(
            f.frame, f.terms, f.metrePer, {x[i], y[i], z[i]}, {nx[i], ny[i], nz[i]});
        outX[i] = moved.position.u;
        outY[i] = moved.position.v;
        outZ[i] = moved.position.h;
        outNx[i] = moved.normal.u;
        outNy[i] = moved.normal.v;
        outNz[i] = moved.normal.h;
    }
}

/// The shortest way that moves vertices so.
auto wayFor(const ChestMotion& motion)
{
    if (motion.right != motion.left)
        return move<true, true>;
    const bool keepsItsPlace = motion.right.shrink == 0.0 && motion.right.shift == 0.0;
    return keepsItsPlace ? move<false, false> : move<false, true>;
}

} // namespace

VertexColumns columnsOf(const TriangleMesh& mesh)
{
    CARINA_EXPECTS(mesh.normals.size() == mesh.positions.size());
    VertexColumns columns;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            columns.position[axis].push_back(mesh.positions[i][static_cast<int>(axis)]);
            columns.normal[axis].push_back(mesh.normals[i][static_cast<int>(axis)]);
        }
    }
    return columns;
}

void deformColumns(const VertexColumns& rest, const ChestField& field, const ChestMotion& motion,
                   VertexColumns& moved)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        CARINA_EXPECTS(rest.position[axis].size() == rest.size());
        CARINA_EXPECTS(rest.normal[axis].size() == rest.size());
        moved.position[axis].resize(rest.size());
        moved.normal[axis].resize(rest.size());
    }
    SingleField single{inSingle(field.frame()), inSingle(motion), {}};
    const Shares<float>& perMetre = single.frame.perMetre;
    single.metrePer = {1.0F / perMetre.u, 1.0F / perMetre.v, 1.0F / perMetre.h};
    const auto moveSome = wayFor(motion);
    const auto& [x, y, z] = rest.position;
    const auto& [nx, ny, nz] = rest.normal;
    auto& [outX, outY, outZ] = moved.position;
    auto& [outNx, outNy, outNz] = moved.normal;
    tbb::parallel_for(tbb::blocked_range<std::size_t>{0, rest.size(), kVerticesAtOnce},
                      [&](const auto& some) {
                          moveSome(single, some.begin(), some.end(), x.data(), y.data(), z.data(),
                                   nx.data(), ny.data(), nz.data(), outX.data(), outY.data(),
                                   outZ.data(), outNx.data(), outNy.data(), outNz.data());
                      });
}

} // namespace carina
