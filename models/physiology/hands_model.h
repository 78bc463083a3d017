#pragma once

#include "models/physiology/gas_model.h"

namespace carina
{

/// What hands do at one station's patient that no sensor feels: they inflate the cuff, draw the
/// stylet, and squeeze a bag.
///
/// The bag is squeezed as often as the patient would breathe quietly, and by as much
/// (restingPattern), until it is let go; it takes the place of a ventilator meanwhile. It is for
/// who is at work at the station, and for instructors; cuff and stylet as GasModel has them. What
/// others set is ignored. A change is sent to every site before it takes effect; until then the
/// getters already return it and `travellingText` lists it.
class HandsModel : public QObject
{
    Q_OBJECT

public:
    /// @pre session outlives this.
    HandsModel(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// At the patient of another station from now on.
    void setStation(StationId station);

    [[nodiscard]] bool isCuffInflated() const { return m_gas.isCuffInflated(); }
    void setCuff(bool inflated) { m_gas.setCuff(inflated); }
    /// Whether a stylet is in the tube that a monitor follows at the station.
    [[nodiscard]] bool hasStylet() const { return m_gas.hasStylet(); }
    void drawStylet() { m_gas.drawStylet(); }
    [[nodiscard]] bool isBagSqueezed() const { return m_bag.shown(0); }
    void squeezeBag(bool squeezed);

    /// One sentence: why this person can handle neither cuff nor stylet; empty if they can.
    [[nodiscard]] QString obstacle() const { return m_gas.obstacleToTube(); }
    /// One sentence: why this person cannot squeeze the bag; empty if they can.
    [[nodiscard]] QString obstacleToBag() const;
    /// The pending changes, one per line; empty if there are none.
    [[nodiscard]] QString travellingText() const;

Q_SIGNALS:
    /// Anything of the above changed.
    void changed();

private:
    using BagChanges = PatientChanges<bool, 1>;

    struct Shown {
        bool isSqueezed = false;
        QString obstacle;
        QString travelling;

        friend bool operator==(const Shown&, const Shown&) = default;
    };

    [[nodiscard]] BagChanges::Quantities quantities();
    [[nodiscard]] RespiratorySettings settingsAt(StationId station, SessionTime t) const;
    [[nodiscard]] HandBag bagOf(StationId station, bool squeezed) const;
    void refresh();

    SessionModel& m_session;
    GasModel m_gas;
    BagChanges m_bag;
    Shown m_shown; ///< at the latest changed()
};

} // namespace carina
