#pragma once

#include <QImage>

namespace carina::lab
{

/// The mean structural similarity of two pictures (MSSIM; Wang, Bovik, Sheikh and Simoncelli, IEEE
/// Trans Image Process 2004;13:600): of their luma (ITU-R BT.601, 0 to 255), in windows of 11x11
/// pixels with Gaussian weights of 1.5 pixels, wholly inside the picture, with K1 = 0.01 and
/// K2 = 0.03, in the pictures' own resolution. 1 where they are equal, less where they differ.
///
/// @pre both have the same size, at least 11x11.
[[nodiscard]] double structuralSimilarity(const QImage& a, const QImage& b);

} // namespace carina::lab
