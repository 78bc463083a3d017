#pragma once

#include "engine/display/eye_picture.h"

#include <QImage>
#include <QSize>

#include <vector>

namespace carina::lab
{

/// Samples of each pixel of a reference, in a grid of kReferenceGrid by kReferenceGrid.
inline constexpr int kReferenceGrid = 4;
inline constexpr int kReferenceSamples = kReferenceGrid * kReferenceGrid;

/// What the eye sees when each pixel's one sample is the middle of this cell of the grid, and not
/// that of the pixel: its frustum, shifted by a part of a pixel.
/// @pre 0 <= sample < kReferenceSamples
[[nodiscard]] EyePicture sampledEye(const EyePicture& eye, const QSize& picture, int sample);

/// The mean of pictures in linear light, by the transfer function of sRGB (IEC 61966-2-1), which
/// is that of a screen.
class ReferencePicture
{
public:
    /// @pre the same size as those before
    void add(const QImage& picture);
    /// @pre at least one was added
    [[nodiscard]] QImage mean() const;

private:
    QSize m_size;
    std::vector<double> m_light; ///< red, green and blue of each pixel, summed
    int m_count = 0;
};

} // namespace carina::lab
