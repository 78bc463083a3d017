#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/session_time.h"
#include "engine/geometry/rigid_transform.h"

#include <QJsonObject>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace carina::program
{

/// Where the simulated manikin truly is before the simulated head: X_HA at a session time.
using TrueView = std::function<std::optional<RigidTransform>(SessionTime)>;

/// How far what a headset showed lay from the manikin behind the glass, at places of the airway:
/// the distance, in the head's frame, between where a place was drawn and where the simulator says
/// that it was when the frame was lit. It holds everything at once: registration, tracker noise,
/// latency and prediction.
class SeenOverlay
{
public:
    SeenOverlay(TrueView truth, const AirwayLandmarks& airway);

    /// A frame that was drawn for a head at X_AH and lit at a time.
    void add(const RigidTransform& X_AH, SessionTime lit);

    /// Per place "mean_mm", "p95_mm" and "largest_mm"; and how many frames. Empty without frames.
    [[nodiscard]] QJsonObject report() const;

private:
    static constexpr std::size_t kPlaces = 3;

    TrueView m_truth;
    std::array<Vec3, kPlaces> m_p_A;
    std::array<std::vector<double>, kPlaces> m_errors_mm;
};

} // namespace carina::program
