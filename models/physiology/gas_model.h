#pragma once

#include "engine/session/body/body_rules.h"
#include "models/respiration/patient_changes.h"
#include "models/session/obstacle_to_change.h"
#include "models/session/session_model.h"

#include <array>
#include <utility>
#include <variant>

namespace carina
{

/// The gas, the tube and the drugs of one station's patient, as people see, set and give them.
///
/// A change is sent to every site before it takes effect; until then the getters already return it
/// and `travellingText` lists it. While one change of a quantity is pending, only the latest
/// further one is kept. Only instructors change gas, say where the tube is, obstruct it and give
/// drugs; cuff and stylet are for trainees at the station, too. What others set is ignored. Gas,
/// tube, cuff and obstruction can be undone; a drug that was given cannot be taken back.
class GasModel : public QObject
{
    Q_OBJECT

public:
    /// @pre session outlives this.
    GasModel(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// Shows the patient of another station from now on. What was changed before is undone where it
    /// was changed.
    void setStation(StationId station);
    /// Adds its changes to a history from now on, by which alone they are to be undone.
    void setHistory(ChangeHistory& history) { m_changes.setHistory(history); }
    [[nodiscard]] bool hasHistory() const { return m_changes.hasHistory(); }
    /// Whether a change is for the patients of all open stations: gas and tube by one fact with one
    /// effect time, a drug by one for each patient, with what it is for that weight.
    void setForAll(bool all);

    // The value requested or, if no change is pending, in force.
    [[nodiscard]] GasSupply gas() const;
    [[nodiscard]] bool isCuffInflated() const;
    /// Share of the tube's lumen that a kink, a bite or secretions take, 0 to 1.
    [[nodiscard]] double obstruction() const;
    /// The tube as the console sets it, whatever is noted of it.
    [[nodiscard]] SetTube tube() const;
    void setGas(const GasSupply& gas) { set(gas); }
    void setCuff(bool inflated) { set(inflated); }
    void setObstruction(double share) { set(share); }
    void setTube(const SetTube& tube) { set(tube); }
    /// The inner diameter of the tube that is set or noted; without one, what is usual for the
    /// patient.
    [[nodiscard]] Length likelyTubeSize() const;

    /// Whether there is a tube: of the console, or one that a monitor follows.
    [[nodiscard]] bool hasTube() const;
    /// Whether a stylet is in the tube that a monitor follows at the station.
    [[nodiscard]] bool hasStylet() const;
    void drawStylet();

    [[nodiscard]] double weight_kg() const;
    /// The largest dose that all can be given for whom a change is.
    [[nodiscard]] double mostDose_mgPerKg(DrugKind kind) const;
    /// Gives a drug by the weight of each patient for whom a change is.
    /// @pre the dose is above 0
    void give(DrugKind kind, double mgPerKg);
    /// What the patient was given within kShownDoses: "Propofol 154 mg, Fentanyl 150 µg"; empty if
    /// nothing.
    [[nodiscard]] QString givenText() const;

    /// Where the tube is that a monitor follows, and whether the console's own setting takes its
    /// place; empty where nobody follows one.
    [[nodiscard]] QString tubeText() const;
    /// The pending changes, one per line; empty if there are none.
    [[nodiscard]] QString travellingText() const;
    /// One sentence: why this person cannot change the gas or give a drug; empty if they can.
    [[nodiscard]] QString obstacle() const { return obstacleToChange(m_session); }
    /// One sentence: why this person can handle neither cuff nor stylet; empty if they can.
    [[nodiscard]] QString obstacleToTube() const
    {
        return carina::obstacleToTube(m_session, m_changes.stations().shown);
    }

    [[nodiscard]] bool canUndo() const { return m_changes.canUndo(); }
    /// Reverts the last change of gas, tube, cuff or obstruction, at each station where nobody
    /// decided otherwise since.
    void undo() { m_changes.undo(); }

    static constexpr Duration kShownDoses = std::chrono::minutes{1};

Q_SIGNALS:
    /// Anything of the above changed.
    void changed();

private:
    /// One of the quantities; its index in the variant says which.
    using Decision = std::variant<GasSupply, bool, double, SetTube>;
    static constexpr std::size_t kThings = std::variant_size_v<Decision>;
    using Changes = PatientChanges<Decision, kThings>;

    struct Shown {
        std::array<Decision, kThings> decisions{GasSupply{}, false, 0.0, SetTube{}};
        std::array<bool, kThings> pending{};
        QString given;
        QString tube;
        QString obstacle;
        QString obstacleToTube;
        double weight_kg = 0.0;
        bool hasTube = false;
        bool hasStylet = false;
        bool canUndo = false;

        friend bool operator==(const Shown&, const Shown&) = default;
    };

    [[nodiscard]] Changes::Quantities quantities();
    [[nodiscard]] double weightAt(StationId station) const;
    [[nodiscard]] static QString textOf(const Decision& decision);
    void set(const Decision& decision);
    void refresh();

    SessionModel& m_session;
    Changes m_changes;
    Shown m_shown; ///< at the latest changed()
};

} // namespace carina
