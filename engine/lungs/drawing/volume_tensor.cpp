#include "engine/lungs/drawing/volume_tensor.h"

#include "engine/core/expects.h"

#include <algorithm>

namespace carina
{

void VolumeTensor::add(const TriangleMesh& mesh, const Fields& fields)
{
    if (mesh.empty())
        return;
    for (const std::vector<Vec3>& field : fields)
        CARINA_EXPECTS(field.size() == mesh.positions.size());
    const Vec3 origin = mesh.positions.front().cast<double>();
    std::array<std::array<Vec3, kFields>, 3> corner;
    for (const Triangle& triangle : mesh.triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
            corner[c][0] = mesh.positions[triangle[c]].cast<double>() - origin;
            for (std::size_t k = 0; k < kModes; ++k)
                corner[c][k + 1] = fields[k][triangle[c]];
        }
        for (std::size_t k = 0; k < kFields; ++k) {
            for (std::size_t l = 0; l < kFields; ++l) {
                const Vec3 across = corner[1][k].cross(corner[2][l]) / 6.0;
                for (std::size_t j = 0; j < kFields; ++j) {
                    std::array order{j, k, l};
                    std::ranges::sort(order);
                    m_t[order[0]][order[1]][order[2]] += corner[0][j].dot(across);
                }
            }
        }
    }
}

VolumeCubic VolumeTensor::along(const Amplitudes& given, const Amplitudes& along) const
{
    // Each a_k is a line in s: p[k] + s q[k].
    std::array<double, kFields> p{1.0};
    std::array<double, kFields> q{0.0};
    std::ranges::copy(given, p.begin() + 1);
    std::ranges::copy(along, q.begin() + 1);
    VolumeCubic cubic;
    for (std::size_t j = 0; j < kFields; ++j) {
        for (std::size_t k = j; k < kFields; ++k) {
            for (std::size_t l = k; l < kFields; ++l) {
                const double t = m_t[j][k][l];
                cubic.c[0] += t * p[j] * p[k] * p[l];
                cubic.c[1] += t * (q[j] * p[k] * p[l] + p[j] * q[k] * p[l] + p[j] * p[k] * q[l]);
                cubic.c[2] += t * (p[j] * q[k] * q[l] + q[j] * p[k] * q[l] + q[j] * q[k] * p[l]);
                cubic.c[3] += t * q[j] * q[k] * q[l];
            }
        }
    }
    return cubic;
}

} // namespace carina
