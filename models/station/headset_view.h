#pragma once

#include "engine/display/eye_picture.h"
#include "engine/tracking/pose_sample.h"

#include <QString>

#include <optional>
#include <vector>

namespace carina
{

/// What a viewer's window is made for.
enum class ViewOutput : std::uint8_t {
    Screen,     ///< a desktop: seen by a camera that a person turns
    Mono,       ///< a headset with one picture for both eyes, seen from midway between them
    SideBySide, ///< a headset with the left eye's picture in the left half, the right's in the
                ///< right
};

/// The output that a word names: "screen", "mono" or "side-by-side".
/// @returns WrongOption with the word.
[[nodiscard]] Result<ViewOutput> viewOutputNamed(const QString& word);

/// The pictures that a headset's eyes need of the station that its wearer stands at.
class HeadsetView
{
public:
    /// @returns what eyeView refuses of either eye or of the place midway between them.
    [[nodiscard]] static Result<HeadsetView> of(const DisplayGeometry& display);

    /// The eyes' pictures with the head H at X_AH: one or two, and no list at all for a screen. An
    /// empty list while the head is lost or was never seen, for then nobody knows what lies behind
    /// the glass.
    [[nodiscard]] std::optional<std::vector<EyePicture>>
    eyes(ViewOutput output, const std::optional<PoseSample>& head) const;

private:
    HeadsetView() = default;

    EyeView m_left;
    EyeView m_right;
    EyeView m_middle;
};

} // namespace carina
