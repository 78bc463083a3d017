#pragma once

#include "engine/anatomy/anatomy.h"
#include "models/station/headset_view.h"

#include <array>
#include <cstdint>
#include <vector>

namespace carina::lab
{

/// What is drawn to check the geometry of a headset's pictures.
struct GeometryTrial {
    int poses = 50;      ///< of the head, about the place from where an intubator looks
    int geometries = 20; ///< of eyes and screen
    std::uint32_t seed = 1;
};

/// The pictures of a trial in their order: each pose of the head with each geometry of the display,
/// made from nothing but the seed.
class HeadsetSeries
{
public:
    static constexpr std::size_t kPlaces = 7;

    /// @pre both counts are above zero.
    [[nodiscard]] static Result<HeadsetSeries> of(const AirwayLandmarks& airway,
                                                  const GeometryTrial& trial);

    /// Places in and about the patient that the heads look at, in A, metres.
    [[nodiscard]] const std::array<Vec3, kPlaces>& places() const { return m_p_A; }

    [[nodiscard]] std::size_t size() const { return m_X_AH.size() * m_displays.size(); }
    [[nodiscard]] const RigidTransform& head(std::size_t i) const
    {
        return m_X_AH[i / m_displays.size()];
    }
    [[nodiscard]] const DisplayGeometry& display(std::size_t i) const
    {
        return m_displays[i % m_displays.size()];
    }
    /// Side by side, as HeadsetView tells them.
    [[nodiscard]] std::vector<EyePicture> eyes(std::size_t i) const;

private:
    std::array<Vec3, kPlaces> m_p_A{};
    std::vector<RigidTransform> m_X_AH;
    std::vector<DisplayGeometry> m_displays;
    std::vector<HeadsetView> m_headsets;
};

} // namespace carina::lab
