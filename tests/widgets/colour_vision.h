#pragma once

// How far colours are apart for people who lack one kind of cone: seen as Machado, Oliveira and
// Fernandes (IEEE TVCG 15, 2009, table 1, severity 1.0) simulate it on linear sRGB, and held
// against each other in CIELAB (CIE 1976) for a white of D65.

#include <QColor>

#include <algorithm>
#include <array>
#include <cmath>

namespace carina::test
{

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

struct Sight {
    const char* name;
    Matrix seen;
};
inline const std::array<Sight, 4> kSights{{
    {"all cones", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868},
       {0.114503, 0.786281, 0.099216},
       {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968},
       {0.280085, 0.672501, 0.047413},
       {-0.011820, 0.042940, 0.968881}}}},
    {"tritanopia",
     {{{1.255528, -0.076749, -0.178779},
       {-0.078411, 0.930809, 0.147602},
       {0.004733, 0.691367, 0.303900}}}},
}};
inline constexpr Matrix kToXyz{
    {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
inline constexpr Triple kWhite{0.95047, 1.0, 1.08883};

inline Triple times(const Matrix& m, const Triple& v)
{
    Triple product{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            product[i] += m[i][j] * v[j];
    return product;
}

inline double linear(double coded)
{
    return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

/// L, a and b of a colour as it is seen.
inline Triple inLab(const QColor& color, const Sight& sight)
{
    Triple light =
        times(sight.seen, {linear(color.redF()), linear(color.greenF()), linear(color.blueF())});
    for (double& channel : light)
        channel = std::clamp(channel, 0.0, 1.0);
    Triple xyz = times(kToXyz, light);
    for (std::size_t i = 0; i < 3; ++i) {
        const double share = xyz[i] / kWhite[i];
        xyz[i] = share > 0.008856 ? std::cbrt(share) : 7.787 * share + 16.0 / 116.0;
    }
    return {116.0 * xyz[1] - 16.0, 500.0 * (xyz[0] - xyz[1]), 200.0 * (xyz[1] - xyz[2])};
}

inline double apart(const QColor& a, const QColor& b, const Sight& sight)
{
    const Triple p = inLab(a, sight);
    const Triple q = inLab(b, sight);
    return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])
                     + (p[2] - q[2]) * (p[2] - q[2]));
}

} // namespace carina::test
