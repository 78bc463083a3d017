#include "models/station/headset_view.h"

#include "engine/core/expects.h"

namespace carina
{
namespace
{

constexpr WindowPart kWhole{};
constexpr WindowPart kLeftHalf{.x = 0.0, .y = 0.0, .width = 0.5, .height = 1.0};
constexpr WindowPart kRightHalf{.x = 0.5, .y = 0.0, .width = 0.5, .height = 1.0};

EyePicture pictureOf(const EyeView& eye, const RigidTransform& X_AH, const WindowPart& part)
{
    return {X_AH * eye.X_HD, eye.frustum, part};
}

} // namespace

Result<ViewOutput> viewOutputNamed(const QString& word)
{
    if (word == QStringLiteral("screen"))
        return ViewOutput::Screen;
    if (word == QStringLiteral("mono"))
        return ViewOutput::Mono;
    if (word == QStringLiteral("side-by-side"))
        return ViewOutput::SideBySide;
    return fail(Errc::WrongOption,
                "--output takes screen, mono or side-by-side, not '" + word.toStdString() + "'");
}

Result<HeadsetView> HeadsetView::of(const DisplayGeometry& display)
{
    HeadsetView headset;
    for (const auto& [eye, view] :
         {std::pair{Eye::Left, &headset.m_left}, std::pair{Eye::Right, &headset.m_right},
          std::pair{Eye::Middle, &headset.m_middle}}) {
        const Result<EyeView> seen = eyeView(display, eye);
        if (!seen)
            return tl::unexpected(seen.error());
        *view = *seen;
    }
    return headset;
}

HeadsetView HeadsetView::standard()
{
    const Result<HeadsetView> headset = of(defaultDisplay());
    CARINA_EXPECTS(headset.has_value());
    return *headset;
}

std::optional<std::vector<EyePicture>>
HeadsetView::eyes(ViewOutput output, const std::optional<PoseSample>& head) const
{
    if (output == ViewOutput::Screen)
        return std::nullopt;
    if (!head || head->validity == Validity::Lost)
        return std::vector<EyePicture>{};
    return eyesAt(output, head->X_FO);
}

std::optional<std::vector<EyePicture>> HeadsetView::eyesAt(ViewOutput output,
                                                           const RigidTransform& X_AH) const
{
    if (output == ViewOutput::Screen)
        return std::nullopt;
    if (output == ViewOutput::Mono)
        return std::vector{pictureOf(m_middle, X_AH, kWhole)};
    return std::vector{pictureOf(m_left, X_AH, kLeftHalf), pictureOf(m_right, X_AH, kRightHalf)};
}

} // namespace carina
