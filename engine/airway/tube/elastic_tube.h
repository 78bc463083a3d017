#pragma once

#include "engine/airway/tube/tube_in_lumen.h"
#include "engine/anatomy/shapes/tube.h"
#include "engine/core/session_time.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace carina
{

/// How the tissue around an airway lies at a moment, other than in the surfaces.
struct TissueAround {
    TissueMotion motion; ///< as it is drawn without a blade
    TissueMotion push;   ///< by a blade, which makes room beside that
    NeckField neck{};    ///< by which a tube that fits the airway is bent (centreIn)
};
/// The arguments must outlive it.
[[nodiscard]] TissueAround tissueAround(const AirwayField& changes, const FollowingThroat& throat,
                                        const BladeField& blade);

/// The tube with which somebody works, in the patient's airway: an elastic rod that is held at its
/// connector and stays in the lumen (TubeInLumen).
///
/// A fold in session time. Its steps are at whole multiples of kStep, with the pose that the
/// connector had then and the lumen as tissue lay at the moment until which it follows. So the
/// same poses and moments give the same shape, and so do other moments while tissue is at rest. At
/// most kMostSteps are taken at once; of a longer pause only the last ones, and where the connector
/// has gone far meanwhile the tube is laid anew.
class ElasticTube
{
public:
    /// X_AE at a session time; nothing where it was not seen.
    using ConnectorAt = std::function<std::optional<RigidTransform>(SessionTime)>;

    /// @param shape its curve at rest, which is bent as the neck is where it fits the airway, and
    ///              its thickness
    /// @param lumen for tubes as thick as that, with a trunk
    ElasticTube(const TubeShape& shape, std::shared_ptr<const AirwayLumen> lumen);

    /// Takes the steps that are due until a moment.
    void follow(SessionTime until, const ConnectorAt& connectorAt, const TissueAround& tissue);
    /// Lays it anew at a moment as one that is found there (TubeInLumen::found).
    /// @param p_E_tip where its tip is, about
    /// @returns false where it was not seen then, and lies as before
    bool layAnew(SessionTime t, const Vec3& p_E_tip, bool isHeldUp, const ConnectorAt& connectorAt,
                 const TissueAround& tissue);
    /// Forgets how it lay.
    void letGo();

    /// Whether it was seen since it was made or let go.
    [[nodiscard]] bool isLaid() const { return m_laid.has_value(); }
    /// As it lies after the latest step. @pre isLaid()
    [[nodiscard]] const TubeInLumen& tube() const { return m_tube; }
    /// Whether its tip is held up at the vocal cords, or above them: within kAtCords.
    [[nodiscard]] bool isStoppedAtCords() const;
    /// Its centre line, in the frame E of its connector, where that has gone on to X_AE until t: a
    /// few steps on from the latest, which the fold does not keep. For a picture, which shows a
    /// later time than that of poses that are known for good. The steps are those that the fold
    /// would take, and a last one to X_AE: so while tissue is at rest it does not matter until when
    /// it has followed, and who has the same poses draws the same.
    /// @param connectorAt until t, as far as it is known
    /// @pre isLaid()
    [[nodiscard]] std::vector<Vec3> ahead(SessionTime t, const RigidTransform& X_AE,
                                          const ConnectorAt& connectorAt,
                                          const TissueAround& tissue) const;

    /// A tip that cords hold up lies between them: of ours.
    static constexpr Length kAtCords = millimetres(5.0);
    static constexpr Duration kStep{std::chrono::nanoseconds{10'000'000}};
    static constexpr int kMostSteps = 50;
    static constexpr int kMostStepsAhead = 16; ///< of ours

private:
    std::shared_ptr<const AirwayLumen> m_lumen;
    TubeShape m_shape;
    TubeInLumen m_begun; ///< which was never stepped
    TubeInLumen m_tube;
    std::optional<SessionTime> m_laid;    ///< the time of the latest step in which it was seen
    std::optional<SessionTime> m_stepped; ///< the time of the latest step
};

/// The size of a tube of which thickness and curve are known: its inner diameter is that of the
/// size that is most nearly as thick. How stiff it is does not matter to its shape, as nothing
/// acts on it but walls, which are as much stiffer (ElasticRod).
[[nodiscard]] TubeSize sizeOf(const TubeShape& shape);

} // namespace carina
