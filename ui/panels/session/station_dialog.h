#pragma once

#include "models/station/stations_model.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace carina
{

/// Asks for the name of a station, and for the patient of a new one. What is wrong with either is
/// said in words, and the dialog cannot be accepted as long as something is.
class StationDialog : public QDialog
{
    Q_OBJECT

public:
    /// @param station that is named anew; kNoStation for a new one @pre stations outlives this.
    StationDialog(const StationsModel& stations, StationId station, QWidget* parent = nullptr);

    [[nodiscard]] QString name() const;
    /// As StationsModel::add takes it.
    [[nodiscard]] QString patient() const;

private:
    [[nodiscard]] bool isNew() const { return m_station == kNoStation; }
    void refresh();

    const StationsModel& m_stations;
    StationId m_station;
    QLineEdit* m_name;
    QComboBox* m_patient;
    QLabel* m_fault;
    QPushButton* m_accept;
};

} // namespace carina
