#pragma once

namespace Qt3DCore
{
class QEntity;
}
namespace Qt3DRender
{
class QAbstractTexture;
}

namespace carina
{

/// Filter key of the passes that draw the window from a picture in a texture; their values are
/// picture qualities.
inline constexpr auto kFinishPass = "finish";

/// What finishes a picture: a triangle over the whole window, with a pass that smooths edges and
/// one that averages samples. The parent owns its nodes.
class PictureFinish
{
public:
    /// @param smoothed what the first draws from, one sample per pixel
    /// @param fine     what the second draws from, kSamplesPerPixel of them
    PictureFinish(Qt3DRender::QAbstractTexture* smoothed, Qt3DRender::QAbstractTexture* fine,
                  Qt3DCore::QEntity* parent);
};

} // namespace carina
