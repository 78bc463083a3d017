#pragma once

#include "engine/session/facts/fact_rules.h"
#include "models/respiration/patient_changes.h"
#include "models/session/session_model.h"

#include <array>
#include <optional>
#include <utility>

namespace carina
{

/// What can be set about a patient's breathing, in the units of the console.
enum class BreathingParameter : std::uint8_t {
    Rate,        ///< breaths per minute
    TidalVolume, ///< millilitres
    Expiration,  ///< expiratory / inspiratory time: 1.44 for an I:E ratio of 1:1.44
    Own,         ///< 1 while the patient breathes; 0: breathing stops
    BagRate,     ///< squeezes of a bag by hand, per minute; 0: no bag
    BagVolume,   ///< of the bag, millilitres
};
inline constexpr std::array kBreathingParameters{
    BreathingParameter::Rate, BreathingParameter::TidalVolume, BreathingParameter::Expiration,
    BreathingParameter::Own,  BreathingParameter::BagRate,     BreathingParameter::BagVolume};

/// How one station's patient breathes, as an instructor sees and changes it.
///
/// A change is sent to every site before it takes effect; until then `pending` returns it. While
/// one change of a parameter is pending, only the latest further one is kept, so that dragging a
/// slider does not flood the session with facts.
class BreathingModel : public QObject
{
    Q_OBJECT

public:
    /// @pre session outlives this.
    BreathingModel(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// Shows the patient of another station from now on. What was changed before is undone where it
    /// was changed.
    void setStation(StationId station);
    /// Adds its changes to a history from now on, by which alone they are to be undone.
    void setHistory(ChangeHistory& history) { m_changes.setHistory(history); }
    [[nodiscard]] bool hasHistory() const { return m_changes.hasHistory(); }
    /// Whether a change is for the patients of all open stations, by one fact with one effect time;
    /// rate and volume of the bag, which are one fact, by one for each station.
    void setForAll(bool all);

    /// The value in force now.
    [[nodiscard]] double value(BreathingParameter parameter) const;
    /// The value that was requested and is not in force yet.
    [[nodiscard]] std::optional<double> pending(BreathingParameter parameter) const;
    /// The largest tidal volume that can be set, for all whom a change is for; whole millilitres.
    [[nodiscard]] int largestTidalVolume_ml() const;
    /// The pending changes, one per line: "Breathing rate → 24 /min"; empty if there are none.
    [[nodiscard]] QString travellingText() const;

    [[nodiscard]] bool canUndo() const { return m_changes.canUndo(); }

    void set(BreathingParameter parameter, double value)
    {
        m_changes.set(std::size_t(parameter), value, m_over);
    }
    /// How long breathing takes to stop or to go on again, from the next such change on.
    void setStoppingTime(Duration over) { m_over = over; }
    /// The share of the patient's own breathing that is left now, 0 to 1.
    [[nodiscard]] double ownBreathing() const;
    /// Sets the parameter changed last back to what it was before, at each station where nobody
    /// decided otherwise since; at once, also where the change was one over a time.
    void undo() { m_changes.undo(); }

Q_SIGNALS:
    /// Values, their bounds, what is pending, or whether undo is possible changed.
    void changed();

private:
    /// The parameters by their numbers.
    using Changes = PatientChanges<double, kBreathingParameters.size()>;
    using Setting = Changes::Setting;

    struct Shown {
        std::array<std::pair<double, std::optional<double>>, kBreathingParameters.size()> values;
        int largestTidalVolume_ml = 0;
        double ownBreathing = 1.0;
        bool canUndo = false;

        friend bool operator==(const Shown&, const Shown&) = default;
    };

    [[nodiscard]] Changes::Quantities quantities();
    [[nodiscard]] static QString textOf(BreathingParameter parameter, double value);
    [[nodiscard]] double valueAt(StationId station, SessionTime t,
                                 BreathingParameter parameter) const;
    [[nodiscard]] double askedAt(StationId station, BreathingParameter parameter) const;
    void propose(BreathingParameter parameter, const Setting& setting);
    void proposeBag(BreathingParameter parameter, const Setting& setting);
    void refresh();

    SessionModel& m_session;
    Changes m_changes;
    Duration m_over{};
    Shown m_shown; ///< at the latest changed()
};

} // namespace carina
