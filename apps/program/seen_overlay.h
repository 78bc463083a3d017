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

/// The ground truth of the simulator: X_HA, the manikin's anatomy in the head frame, at a session
/// time.
using TrueView = std::function<std::optional<RigidTransform>(SessionTime)>;

/// The overlay error of a headset at points of the airway: the distance, in the head frame, between
/// the drawn point and its true position when the frame was lit. It includes all error sources:
/// registration, tracker noise, latency and prediction.
class SeenOverlay
{
public:
    SeenOverlay(TrueView truth, const AirwayLandmarks& airway);

    /// Adds a frame that was drawn for a head at X_AH and lit at a time.
    void add(const RigidTransform& X_AH, SessionTime lit);

    /// Per point "mean_mm", "p95_mm" and "largest_mm"; and the number of frames. Empty without
    /// frames.
    [[nodiscard]] QJsonObject report() const;

private:
    static constexpr std::size_t kPlaces = 3;

    TrueView m_truth;
    std::array<Vec3, kPlaces> m_p_A;
    std::array<std::vector<double>, kPlaces> m_errors_mm;
};

} // namespace carina::program
