#pragma once

#include "engine/display/eye_picture.h"
#include "engine/tracking/pose_sample.h"

#include <QString>

#include <optional>
#include <vector>

namespace carina
{

/// The display device of a viewer's window.
enum class ViewOutput : std::uint8_t {
    Screen,     ///< a desktop, with a camera that a person turns
    Mono,       ///< a headset with one picture for both eyes, seen from midway between them
    SideBySide, ///< a headset with the left eye's picture in the left half, the right's in the
                ///< right
};

/// The output named "screen", "mono" or "side-by-side".
/// @returns WrongOption with the word.
[[nodiscard]] Result<ViewOutput> viewOutputNamed(const QString& word);

/// The pictures for the eyes of a headset.
class HeadsetView
{
public:
    /// @returns the error of eyeView for either eye or for the point midway between them.
    [[nodiscard]] static Result<HeadsetView> of(const DisplayGeometry& display);

    /// That of defaultDisplay().
    [[nodiscard]] static HeadsetView standard();

    /// The eyes' pictures with the head H at X_AH: one or two; std::nullopt for a screen. An empty
    /// list while the head is lost or was never seen, because its view is then unknown.
    [[nodiscard]] std::optional<std::vector<EyePicture>>
    eyes(ViewOutput output, const std::optional<PoseSample>& head) const;

    /// The same of a head whose place is known.
    [[nodiscard]] std::optional<std::vector<EyePicture>> eyesAt(ViewOutput output,
                                                                const RigidTransform& X_AH) const;

private:
    HeadsetView() = default;

    EyeView m_left;
    EyeView m_right;
    EyeView m_middle;
};

} // namespace carina
