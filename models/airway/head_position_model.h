#pragma once

#include "engine/session/airway/airway_rules.h"
#include "models/airway/gradual_decision.h"

namespace carina
{

/// How head and neck of one station's patient lie.
class HeadPositionModel : public GradualDecisionOf<HeadPosition>
{
    Q_OBJECT

public:
    /// @pre session outlives this.
    HeadPositionModel(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// Whether a change is for the patients of all open stations, by one fact with one effect time.
    void setForAll(bool all) { setAddressed(all); }

    /// What was set: requested or, if no change is pending, decided.
    [[nodiscard]] HeadPosition position() const { return decided(); }
    /// How they are to be seen now, while that changes, and as far as a stiff neck lets them.
    [[nodiscard]] HeadPosition present() const { return presentValue(); }
    /// Whether they are to be seen in neutral position.
    [[nodiscard]] bool isNeutral() const { return present() == HeadPosition{}; }

    /// @pre within the range that is drawn (withinReach)
    void setPosition(const HeadPosition& position);

    /// As they are to be seen now: "neck 35° flexed, head 24° extended".
    [[nodiscard]] QString inForceText() const;

private:
    [[nodiscard]] static Kind howDecided();
};

} // namespace carina
