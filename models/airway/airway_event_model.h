#pragma once

#include "engine/session/airway/airway_rules.h"
#include "models/airway/airway_limits.h"
#include "models/airway/gradual_decision.h"

#include <QPointer>

#include <optional>
#include <string>

namespace carina
{

class SessionPatient;

/// How long suction takes until no fluid is left; of ours.
inline constexpr Duration kSuction = std::chrono::seconds{5};

/// The events of one station's airway. The airway is one thing of the patient, whichever of its
/// events is changed.
class AirwayEventModel : public GradualDecisionOf<AirwayEvents>
{
    Q_OBJECT

public:
    /// @pre session outlives this.
    AirwayEventModel(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// Whether a change is for the patients of all open stations, by one fact with one effect time.
    void setForAll(bool all);
    /// Tells from now on also what the patient cannot show that lies at the station, as soon as it
    /// is known which one does.
    void setPatient(const SessionPatient& patient);

    /// The severity that was set: requested or, if no change is pending, decided; 0 without one.
    [[nodiscard]] double severity(AirwayEventKind kind) const;
    /// The severity that is to be seen now, while it changes.
    [[nodiscard]] double present(AirwayEventKind kind) const;
    /// The severity with which it is drawn now in the patient of the station: less than that where
    /// it shares the room of the throat (asDrawn), between swallows; 0 where it is not shown.
    [[nodiscard]] double drawn(AirwayEventKind kind) const;
    /// All that was set likewise, without those of severity 0.
    [[nodiscard]] AirwayEvents events() const { return decided(); }
    /// Whether any is to be seen now, also one that was ended and goes slowly.
    [[nodiscard]] bool isSeen() const { return !presentValue().empty(); }
    /// What the patient of the station cannot show of it; nothing while the patient is not known.
    [[nodiscard]] const AirwayLimits& limits() const { return m_limits; }
    /// Whether there is anything to set: an event that the patient shows, or one to be ended, or
    /// one of other patients too.
    [[nodiscard]] bool canBeSet(AirwayEventKind kind) const;

    /// Sets the severity of one event, 0 to 1, and leaves the others as they are set.
    void setSeverity(AirwayEventKind kind, double severity);
    /// Sets all events at once, as one change; what is not among them ends. @pre areProper(events)
    void setEvents(const AirwayEvents& events);
    /// Sets no event at all.
    void clear() { setEvents({}); }

    /// Whether an airway for which a change is has an event, or is to have one.
    [[nodiscard]] bool hasEvents() const;
    /// Whether a fluid stands in a throat for which a change is, or is to stand there.
    [[nodiscard]] bool hasFluid() const;
    /// Takes all fluids away, as who works there does with suction, over kSuction instead of the
    /// time of a change; for the patients of all stations by one fact for each. All other events
    /// stay as they are set there; what of them is still on its way comes within kSuction, too.
    void suction();

    /// The events to be seen now, in few words: "Tongue oedema 60 %", "Anaphylaxis"; "Clear".
    [[nodiscard]] QString inForceText() const;

private:
    [[nodiscard]] static Kind howDecided();
    /// At any of the addressed stations, of what is wanted or to be seen there.
    [[nodiscard]] bool isAnywhere(bool (*is)(const AirwayEvents& events)) const;
    /// What there is at all addressed stations, and the limits.
    [[nodiscard]] bool refreshMore() override;
    /// Those of the patient that lies there.
    [[nodiscard]] bool refreshLimits();

    // At the latest look.
    bool m_hasEvents = false;
    bool m_hasFluid = false;
    QPointer<const SessionPatient> m_patient;
    AirwayLimits m_limits;
    std::optional<std::string> m_limitsOf; ///< content hash of the patient whose they are
};

} // namespace carina
