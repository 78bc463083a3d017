#pragma once

#include "models/registration/landmark_table_model.h"

#include <QTableView>

#include <functional>

namespace carina
{

class ResidualBar;

/// The landmarks of a registration as a table; a click on one, or Space on it, chooses it.
class LandmarkList : public QTableView
{
    Q_OBJECT

public:
    /// @pre registration outlives it.
    explicit LandmarkList(const RegistrationModel& registration, QWidget* parent = nullptr);

    /// Shows only these columns.
    void showColumns(std::initializer_list<LandmarkTableModel::Column> columns);
    void refresh();

Q_SIGNALS:
    void chosen(std::size_t landmark);

private:
    const RegistrationModel& m_registration;
    LandmarkTableModel m_landmarks;
    ResidualBar* m_bars; ///< a child of this
};

} // namespace carina
