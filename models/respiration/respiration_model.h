#pragma once

#include "engine/lungs/mechanics/lung_condition.h"
#include "engine/lungs/mechanics/ventilation.h"
#include "engine/session/facts/fact_rules.h"
#include "engine/session/respiration/respiration_rules.h"
#include "models/respiration/patient_changes.h"
#include "models/session/obstacle_to_change.h"
#include "models/session/session_model.h"

#include <array>
#include <optional>
#include <utility>
#include <variant>

namespace carina
{

/// The lung diseases, body position and ventilator of one station's patient, as an instructor
/// sees and changes them.
///
/// A change is sent to every site before it takes effect; until then the getters already return it
/// and `travellingText` lists it. While one change of a quantity is pending, only the latest
/// further one is kept, so that dragging a severity does not flood the session with facts. Only
/// instructors can change anything; what others set is ignored.
class RespirationModel : public QObject
{
    Q_OBJECT

public:
    /// @pre session outlives this.
    RespirationModel(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// Shows the patient of another station from now on. What was changed before is undone where it
    /// was changed.
    void setStation(StationId station);
    /// Adds its changes to a history from now on, by which alone they are to be undone.
    void setHistory(ChangeHistory& history) { m_changes.setHistory(history); }
    [[nodiscard]] bool hasHistory() const { return m_changes.hasHistory(); }
    /// Whether a change is for the patients of all open stations, by one fact with one effect time.
    void setForAll(bool all) { m_changes.setForAll(all); }

    // The value requested or, if no change is pending, in force.
    [[nodiscard]] LungConditions conditions() const;
    [[nodiscard]] VentilatorSettings ventilator() const;
    [[nodiscard]] BodyPosition position() const;

    /// Makes the disease at this place another one, with the present severity, or 0.5 if that is 0;
    /// the place behind the last adds one, and ConditionKind::Normal removes it. A disease that is
    /// usually one-sided gets the present side, or the right one if both were affected; any other,
    /// both sides. Where a lung has this disease already, the other lung gets it; where both have,
    /// nothing changes.
    void choose(std::size_t place, ConditionKind kind);
    /// Sets the disease at this place; the place behind the last adds one. A mainstem intubation of
    /// both sides is taken as one of the right side. Nothing changes where the patient cannot have
    /// all these at once (canCoexist).
    void setCondition(std::size_t place, LungCondition condition);
    void removeCondition(std::size_t place);
    /// Whether choose would set this disease at this place.
    [[nodiscard]] bool canChoose(std::size_t place, ConditionKind kind) const;
    void setVentilator(const VentilatorSettings& settings) { set(settings); }
    void setPosition(BodyPosition position) { set(position); }

    /// The diseases in force, that the patient's own breathing has stopped and, unless supine, the
    /// position: "COPD, both lungs, severity 0.60; prone".
    [[nodiscard]] QString inForceText() const;
    /// The pending changes, one per line: "Condition → COPD, both lungs, severity 0.60"; empty if
    /// there are none.
    [[nodiscard]] QString travellingText() const;
    /// One sentence: why this person cannot change anything; empty if they can.
    [[nodiscard]] QString obstacle() const { return obstacleToChange(m_session); }

    [[nodiscard]] bool canUndo() const { return m_changes.canUndo(); }
    /// Reverts the last change, at each station where nobody decided otherwise since.
    void undo() { m_changes.undo(); }

Q_SIGNALS:
    /// Anything of the above changed.
    void changed();

private:
    /// One of the quantities; its index in the variant says which.
    using Decision = std::variant<LungConditions, VentilatorSettings, BodyPosition>;
    static constexpr std::size_t kThings = std::variant_size_v<Decision>;
    using Changes = PatientChanges<Decision, kThings>;

    struct Shown {
        std::array<Decision, kThings> decisions{LungConditions{}, VentilatorSettings{},
                                                BodyPosition{}};
        std::array<bool, kThings> pending{};
        QString obstacle;
        bool canUndo = false;

        friend bool operator==(const Shown&, const Shown&) = default;
    };

    [[nodiscard]] Changes::Quantities quantities();
    [[nodiscard]] Decision decidedAt(StationId station, std::size_t thing, SessionTime t) const;
    [[nodiscard]] double ownBreathing() const;
    [[nodiscard]] std::optional<LungConditions> with(std::size_t place, ConditionKind kind) const;
    [[nodiscard]] static QString textOf(std::size_t thing, const Decision& decision);
    void set(const Decision& decision);
    void refresh();

    SessionModel& m_session;
    Changes m_changes;
    Shown m_shown; ///< at the latest changed()
};

} // namespace carina
