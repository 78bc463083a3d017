#pragma once

#include "apps/lab/attack/attacks.h"

namespace carina::lab
{

/// One person under many names, each of which shares objects and streams all of them, so that
/// everybody is sent them and keeps them: more than a station has room for.
[[nodiscard]] std::unique_ptr<Attack> beginGallery(const Target& target);

/// Names of a gallery, and objects of each: two jaws and two styluses, which are not drawn, so that
/// what is measured is the network and not the picture.
inline constexpr int kGalleryNames = 32;
inline constexpr int kGalleryObjects = 4;

} // namespace carina::lab
