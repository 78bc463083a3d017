#include "apps/lab/rendering/reference_picture.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina::lab
{
namespace
{

double lightOf(int coded)
{
    const double c = coded / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

int codedLight(double light)
{
    const double c =
        light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
    return std::clamp(static_cast<int>(std::lround(255.0 * c)), 0, 255);
}

std::array<double, 256> lightTable()
{
    std::array<double, 256> table{};
    for (int coded = 0; coded < 256; ++coded)
        table[std::size_t(coded)] = lightOf(coded);
    return table;
}

} // namespace

EyePicture sampledEye(const EyePicture& eye, const QSize& picture, int sample)
{
    CARINA_EXPECTS(sample >= 0 && sample < kReferenceSamples);
    const auto beside = [](int cell) { return (cell + 0.5) / kReferenceGrid - 0.5; }; // pixels
    const double across = (eye.frustum.right - eye.frustum.left) / picture.width();
    const double up = (eye.frustum.top - eye.frustum.bottom) / picture.height();
    const double right_px = beside(sample % kReferenceGrid);
    const double up_px = beside(sample / kReferenceGrid);
    EyePicture sampled = eye;
    sampled.frustum.left += right_px * across;
    sampled.frustum.right += right_px * across;
    sampled.frustum.bottom += up_px * up;
    sampled.frustum.top += up_px * up;
    return sampled;
}

void ReferencePicture::add(const QImage& picture)
{
    static const std::array<double, 256> kLight = lightTable();
    CARINA_EXPECTS(m_count == 0 || picture.size() == m_size);
    m_size = picture.size();
    m_light.resize(3 * std::size_t(m_size.width()) * std::size_t(m_size.height()));
    std::size_t place = 0;
    for (int y = 0; y < m_size.height(); ++y)
        for (int x = 0; x < m_size.width(); ++x) {
            const QRgb pixel = picture.pixel(x, y);
            for (const int coded : {qRed(pixel), qGreen(pixel), qBlue(pixel)})
                m_light[place++] += kLight[std::size_t(coded)];
        }
    ++m_count;
}

QImage ReferencePicture::mean() const
{
    CARINA_EXPECTS(m_count > 0);
    QImage image{m_size, QImage::Format_RGB32};
    std::size_t place = 0;
    const auto next = [&] { return codedLight(m_light[place++] / m_count); };
    for (int y = 0; y < m_size.height(); ++y)
        for (int x = 0; x < m_size.width(); ++x) {
            const int red = next();
            const int green = next();
            const int blue = next();
            image.setPixel(x, y, qRgb(red, green, blue));
        }
    return image;
}

} // namespace carina::lab
